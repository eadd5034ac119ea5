#include <fmt/format.h>

#include <array>
#include <cmath>

#include "app/run/counted.h"
#include "app/sweep/sweep.h"

namespace knuckle {

namespace {

constexpr std::array STAGES{RunStage::Done, RunStage::Running, RunStage::Left, RunStage::Waiting, RunStage::Failed};

const char* wordOf(RunStage stage)
{
    switch (stage) {
        case RunStage::Waiting: return "waiting";
        case RunStage::Running: return "running";
        case RunStage::Left: return "left";
        case RunStage::Failed: return "failed";
        case RunStage::Done: break;
    }
    return "done";
}

/// What there is to say of a run; empty: nothing.
std::string lineOf(const SweepRun& run, const RunStanding& state, const RunFolder& folder)
{
    std::string text;
    if (state.claim) {
        const Worker& worker = state.claim->worker;
        text = fmt::format("{} by process {} on {}, seen {:.0f} s ago", wordOf(state.stage), worker.process,
                           worker.host.empty() ? "an unknown machine" : worker.host, std::max(0.0, state.claim->age));
    }
    if (state.failures > 0)
        text += fmt::format("{}failed {}: {}; {}", text.empty() ? "" : ", ", counted(state.failures, "time"),
                            state.line, folder.log());
    return text.empty() ? text : fmt::format("run {}: {}\n", run.number, text);
}

Json jsonOf(const SweepRun& run, const RunStanding& state)
{
    Json json = {{"run", run.number}, {"stage", wordOf(state.stage)}, {"failures", state.failures}};
    if (!state.line.empty()) json["line"] = state.line;
    if (state.claim) {
        json["host"] = state.claim->worker.host;
        json["process"] = state.claim->worker.process;
        json["age"] = state.claim->age;
    }
    return json;
}

}  // namespace

void printStatus(const Sweep& sweep, const Watch& watch, bool json)
{
    sweep.requireRuns();
    Watch now = watch;
    now.now = storedNow(sweep.folder);
    std::array<size_t, STAGES.size()> counts{};
    std::string lines;
    Json list = Json::array();
    for (const SweepRun& run : sweep.runs) {
        const RunFolder folder = sweep.folderOf(run);
        const RunStanding state = folder.look(now);
        for (size_t k = 0; k < STAGES.size(); ++k) counts[k] += STAGES[k] == state.stage ? 1 : 0;
        if (json) list.push_back(jsonOf(run, state));
        else lines += lineOf(run, state, folder);
    }
    if (json) {
        fmt::print("{}\n", list.dump(2));
        return;
    }
    fmt::print("{}: {} in {}\n", sweep.plan.name, counted(sweep.runs.size(), "run"), sweep.folder);
    for (size_t k = 0; k < STAGES.size(); ++k)
        if (counts[k] > 0) fmt::print("  {:<8}{:>8}\n", wordOf(STAGES[k]), counts[k]);
    fmt::print("{}", lines);
}

}  // namespace knuckle
