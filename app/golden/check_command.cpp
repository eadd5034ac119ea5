#include <fmt/format.h>

#include <filesystem>
#include <mutex>
#include <set>

#include "app/compare/compare_run.h"
#include "app/golden/golden_commands.h"
#include "app/run/counted.h"
#include "app/run/exit_codes.h"
#include "app/run/progress.h"
#include "app/run/shell_command.h"
#include "app/run/tell.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

using Status = ReportEntry::Status;

Json stateJson(const StateDifference& state)
{
    Json json = {{"sameBits", state.sameBits}};
    if (state.sameBits) return json;
    json.update({{"particles", state.particles},
                 {"storedParticles", state.storedParticles},
                 {"moved", state.moved},
                 {"mean", state.mean},
                 {"largest", state.largest},
                 {"cameOrWent", state.cameOrWent},
                 {"torn", state.torn},
                 {"colliders", state.colliders},
                 {"farthest", state.farthest},
                 {"object", state.owner}});
    return json;
}

Json itemJson(const GoldenItem& item)
{
    Json json = {{"golden", item.golden},          {"image", item.stem},
                 {"kind", kindWord(item.kind)},    {"verdict", item.entry.statusWord()},
                 {"advisory", item.entry.allowed}, {"line", item.entry.line}};
    if (item.state) json["state"] = stateJson(*item.state);
    else if (item.entry.status == Status::Different || item.entry.status == Status::Equal)
        json["picture"] = comparisonToJson(item.entry, {});
    return json;
}

void printJson(const GoldenChoice& choice, const std::vector<Golden>& goldens,
               const std::vector<CheckedGolden>& checked, const char* verdict)
{
    Json json = {{"folder", choice.folder}, {"verdict", verdict}, {"goldens", Json::array()}};
    for (size_t i = 0; i < checked.size(); ++i) {
        Json items = Json::array();
        for (const GoldenItem& item : checked[i].items) items.push_back(itemJson(item));
        json["goldens"].push_back({{"name", goldens[i].name},
                                   {"reference", checked[i].reference.key},
                                   {"ownDriver", checked[i].reference.own},
                                   {"items", std::move(items)}});
    }
    fmt::print("{}\n", json.dump(2, ' ', false, Json::error_handler_t::replace));
}

/// Figures for the last line, over all goldens.
class Summary {
public:
    void add(const Golden& golden, const CheckedGolden& checked)
    {
        for (const GoldenItem& item : checked.items) {
            if (item.entry.status == Status::Unreadable && item.entry.failed()) {
                ++unreadable_;
                continue;
            }
            Counts& counts = item.kind == GoldenItem::Kind::Physics ? states_ : pictures_;
            ++counts.all;
            if (item.entry.failed()) ++counts.different;
            else if (item.entry.status != Status::Equal) ++advisory_;
        }
        if (checked.failed()) failed_.push_back(golden.folder);
    }

    std::string text(size_t goldens) const
    {
        std::string text = counted(goldens, "golden") + ": ";
        const auto share = [](const Counts& counts, const char* what) {
            return counts.all == 0 ? "" : fmt::format("{} of {} {}", counts.different, counts.all, what);
        };
        const std::string states = share(states_, "states"), pictures = share(pictures_, "pictures");
        if (states.empty() && pictures.empty()) text += "nothing compared";
        else text += states + (states.empty() || pictures.empty() ? "" : " and ") + pictures + " differ";
        if (unreadable_ > 0) text += fmt::format(", {} cannot be checked", unreadable_);
        if (advisory_ > 0) text += fmt::format(", {} advisory", counted(advisory_, "difference"));
        return text;
    }
    const char* word() const { return differs() ? "different" : unreadable() ? "unreadable" : "equal"; }
    bool differs() const { return states_.different + pictures_.different > 0; }
    bool unreadable() const { return unreadable_ > 0; }
    /// The command that accepts what failed.
    std::string remedy(const GoldenChoice& choice) const
    {
        std::string command = "knuckle golden update " + quotedForShell(choice.folder);
        if (failed_.size() > MOST_NAMED) return command;
        for (const std::string& folder : failed_)
            command += " " +
                       quotedForShell(std::filesystem::path(folder).lexically_relative(choice.folder).generic_string());
        return command;
    }

private:
    static constexpr size_t MOST_NAMED = 8;
    struct Counts {
        uint64_t all = 0, different = 0;
    };
    Counts states_, pictures_;
    uint64_t unreadable_ = 0, advisory_ = 0;
    std::vector<std::string> failed_;
};

std::string nameOf(const GoldenItem& item)
{
    return item.stem.empty() ? item.golden : item.golden + "/" + item.stem;
}

void printLines(const CheckedGolden& checked)
{
    for (const GoldenItem& item : checked.items) {
        if (item.entry.status == Status::Equal || item.entry.status == Status::Unreadable) continue;
        fmt::print("{}{}: {}\n", item.entry.allowed ? "advisory: " : "", nameOf(item), item.entry.line);
    }
}

/// Names each driver whose references stand in for another's.
void tellStandIns(const std::vector<CheckedGolden>& checked, const Gpu* gpu)
{
    std::set<std::string> keys;
    for (const CheckedGolden& golden : checked)
        if (!golden.reference.own) keys.insert(golden.reference.key);
    for (const std::string& key : keys)
        fmt::print("no references of {}, {}: compared with those of {}\n", gpu->device().name, gpu->device().version,
                   key);
}

}  // namespace

GoldenChoice GoldenChoice::parse(const std::vector<std::string>& words)
{
    std::error_code ignored;
    if (!words.empty() && std::filesystem::is_directory(words[0], ignored))
        return {words[0], {words.begin() + 1, words.end()}};
    if (!std::filesystem::is_directory("golden", ignored))
        throw InputError(words.empty() ? "no folder golden here; name the folder of the goldens"
                                       : fmt::format("no folder {}; name the folder of the goldens first", words[0]));
    return {"golden", words};
}

int checkGoldens(const GoldenChoice& choice, const CheckOptions& options, bool json, const CommonOptions& common)
{
    const std::vector<Golden> goldens = findGoldens(choice.folder, choice.names);
    RunPaths paths;
    for (const Golden& golden : goldens) paths.reads(golden.path());
    ReportOutputs outputs(options.reports, paths);
    paths.check();
    outputs.open();
    const auto gpu = openFor(goldens, common);
    std::vector<CheckedGolden> checked(goldens.size());
    {
        const InterruptGuard interrupt;
        Progress progress("golden", goldens.size(), common.quiet);
        uint64_t done = 0;
        std::mutex mutex;
        forEachGolden(goldens.size(), gpu.get(), [&](size_t i, Gpu* own) {
            checked[i] = checkGolden(goldens[i], options, own, interrupt);
            const std::lock_guard lock(mutex);
            progress.update(++done);
        });
    }
    Summary summary;
    for (size_t i = 0; i < goldens.size(); ++i) summary.add(goldens[i], checked[i]);
    if (json) printJson(choice, goldens, checked, summary.word());
    else if (!common.quiet) {
        for (const CheckedGolden& golden : checked) printLines(golden);
        tellStandIns(checked, gpu.get());
        fmt::print("{}\n", summary.text(goldens.size()));
        if (summary.differs() && options.changes.empty()) fmt::print("to accept: {}\n", summary.remedy(choice));
    }
    for (CheckedGolden& golden : checked)
        for (GoldenItem& item : golden.items) {
            if (item.entry.status == Status::Unreadable)
                tellUser(fmt::format("knuckle: {}: {}", nameOf(item), item.entry.line));
            outputs.add(std::move(item.entry));
        }
    ReportHead head{"Goldens of " + choice.folder, {{"made by", "knuckle " KNUCKLE_VERSION}}};
    if (gpu) head.notes.emplace_back("this run's device", gpu->device().name + ", " + gpu->device().version);
    outputs.finish(head, "knuckle golden check " + choice.folder);
    if (summary.unreadable()) return EXIT_INPUT;
    return summary.differs() ? EXIT_DIFFERENT : EXIT_FINE;
}

}  // namespace knuckle
