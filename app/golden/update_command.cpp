#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdio>
#include <filesystem>
#include <stdexcept>

#include "app/golden/golden_commands.h"
#include "app/golden/golden_record.h"
#include "app/run/exit_codes.h"
#include "app/run/tell.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Under which name a golden's references are written.
struct Target {
    std::string key;
    bool whole = false;         ///< All are made, whatever is there.
    std::string replaces = {};  ///< The name of references that are removed; empty: none.
};

/// @throws InputError for a golden with references of other drivers only, unless told what to do with them.
Target targetOf(const Golden& golden, const Gpu* gpu, OtherDriver otherDriver)
{
    if (!golden.ofScene()) return {"", golden.problem.empty() && !golden.recorded.contains("")};
    const DeviceInfo& device = gpu->device();
    if (golden.recorded.empty()) return {driverKey(device.name), true};
    const ChosenReference reference = chooseReference(golden, device);
    if (reference.own) return {reference.key, false};
    if (otherDriver == OtherDriver::Replace) {
        Golden without = golden;
        without.recorded.erase(reference.key);
        return {newKey(without, device), true, reference.key};
    }
    if (otherDriver == OtherDriver::Beside) return {newKey(golden, device), true};
    const GoldenRecord& record = golden.recorded.at(reference.key);
    throw InputError(fmt::format("{}: its references are of {}, {}; this is {}, {}: --other-driver beside keeps both, "
                                 "--other-driver replace only these",
                                 golden.path(), record.device, record.driver, device.name, device.version));
}

/// What has failed of a golden, and must be made anew.
RecordWork failedWork(const Golden& golden, const CheckedGolden& checked, const std::string& key)
{
    RecordWork work{.key = key, .made = true, .states = false};
    for (const GoldenItem& item : checked.items) {
        if (!item.entry.failed()) continue;
        const bool whole = golden.ofScene() && item.frame == 0;  // nothing of it could be read
        if (whole) return wholeWork(golden, key);
        if (item.kind == GoldenItem::Kind::Physics) work.states = true;
        if (item.frame > 0) work.frames.insert(item.frame);
        else work.images.insert(item.stem);
    }
    // Pictures are drawn from states: those of new states are new.
    if (work.states) work.frames.insert(golden.frames.begin(), golden.frames.end());
    return work;
}

struct Update {
    std::vector<std::string> accepted;  ///< Lines of what had failed.
    std::vector<std::string> written;
    std::string problem = {};  ///< Why it could not be updated.
};

void removeReferences(const Golden& golden, const std::string& key)
{
    std::remove(golden.statesFile(key).c_str());
    for (const uint64_t frame : golden.frames) std::remove(golden.reference(golden.frameStem(frame), key).c_str());
}

Update recordWhole(Golden& golden, const Target& target, const UpdateOptions& options, Gpu* gpu,
                   const InterruptGuard& interrupt)
{
    RecordWork work = wholeWork(golden, target.key);
    if (!target.whole) work.states = options.states;
    if (!target.replaces.empty()) golden.recorded.erase(target.replaces);
    Update update{{target.whole ? "new references" : "all references"}, recordGolden(golden, work, gpu, interrupt)};
    if (!target.replaces.empty() && target.replaces != target.key) removeReferences(golden, target.replaces);
    return update;
}

Update updateGolden(Golden& golden, const Target& target, const UpdateOptions& options, Gpu* gpu,
                    const InterruptGuard& interrupt)
{
    if (!golden.problem.empty()) throw InputError(golden.problem);
    if (target.whole || options.all) return recordWhole(golden, target, options, gpu, interrupt);
    Update update;
    CheckOptions looked;
    looked.states = options.states;
    looked.pictures = options.pictures;
    const CheckedGolden checked = checkGolden(golden, looked, gpu, interrupt);
    if (!checked.failed()) return update;
    for (const GoldenItem& item : checked.items)
        if (item.entry.failed())
            update.accepted.push_back(item.stem.empty() ? item.entry.line : item.stem + ": " + item.entry.line);
    // Without a name: the golden itself, or its command, is wrong.
    if (!golden.ofScene() && checked.items.front().stem.empty()) throw InputError(checked.items.front().entry.line);
    update.written = recordGolden(golden, failedWork(golden, checked, target.key), gpu, interrupt);
    return update;
}

void printUpdate(const Golden& golden, const Update& update)
{
    for (const std::string& line : update.accepted) fmt::print("{}: accepts {}\n", golden.name, line);
    std::vector<std::string> names;
    for (const std::string& path : update.written) names.push_back(std::filesystem::path(path).filename().string());
    if (!names.empty()) fmt::print("{}: wrote {}\n", golden.name, fmt::join(names, ", "));
}

}  // namespace

int updateGoldens(const GoldenChoice& choice, const UpdateOptions& options, const CommonOptions& common)
{
    std::vector<Golden> goldens = findGoldens(choice.folder, choice.names);
    const auto gpu = openFor(goldens, common);
    std::vector<Target> targets;
    for (const Golden& golden : goldens) targets.push_back(targetOf(golden, gpu.get(), options.otherDriver));
    std::vector<Update> updates(goldens.size());
    const InterruptGuard interrupt;
    forEachGolden(goldens.size(), gpu.get(), [&](size_t i, Gpu* own) {
        try {
            updates[i] = updateGolden(goldens[i], targets[i], options, own, interrupt);
        } catch (const std::runtime_error& error) {
            updates[i].problem = fmt::format("{}: {}", goldens[i].name, error.what());
        }
    });
    size_t changed = 0;
    bool failed = false;
    for (size_t i = 0; i < goldens.size(); ++i) {
        if (!common.quiet) printUpdate(goldens[i], updates[i]);
        if (!updates[i].written.empty()) ++changed;
        if (updates[i].problem.empty()) continue;
        failed = true;
        tellUser("knuckle: " + updates[i].problem);
    }
    if (!common.quiet) fmt::print("{} of {} goldens written anew\n", changed, goldens.size());
    return failed ? EXIT_INPUT : EXIT_FINE;
}

}  // namespace knuckle
