#include "app/sweep/run_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <map>

#include "app/run/shell_command.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr const char *CLAIM = "claim.", *END = "end.";

/// The number behind a name's beginning; 0: it begins otherwise.
uint64_t numberAfter(const std::string& name, const std::string& beginning)
{
    uint64_t number = 0;
    if (name.starts_with(beginning)) std::from_chars(name.data() + beginning.size(), name.data() + name.size(), number);
    return number;
}

ClaimEnd readEnd(const std::string& path)
{
    std::ifstream file(path);
    const Json json = Json::parse(file, nullptr, false);
    if (!json.is_object()) return {};
    return {json.value("failed", false), json.value("line", "")};
}

}  // namespace

bool RunFolder::isDone() const
{
    std::error_code ignored;
    return fs::exists(done(), ignored);
}

RunStanding RunFolder::look(const Watch& watch) const
{
    RunStanding state;
    if (isDone()) return {.stage = RunStage::Done};
    std::map<uint64_t, ClaimEnd> ends;
    std::error_code ignored;
    for (const fs::directory_entry& entry : fs::directory_iterator(path_, ignored)) {
        const std::string name = entry.path().filename();
        state.claims = std::max(state.claims, numberAfter(name, CLAIM));
        if (const uint64_t number = numberAfter(name, END); number != 0) ends[number] = readEnd(entry.path());
    }
    for (const auto& [number, end] : ends) {
        state.failures += end.failed ? 1 : 0;
        if (end.failed) state.line = end.line;
    }
    if (state.claims > 0 && !ends.contains(state.claims)) {
        state.claim = readClaim(path_, state.claims, watch.now);
        const bool left = state.claim && state.claim->isLeft(watch.self, watch.staleSeconds);
        // It may have been done since.
        state.stage = isDone() ? RunStage::Done : left ? RunStage::Left : RunStage::Running;
    } else if (state.failures >= watch.tries) {
        state.stage = RunStage::Failed;
    }
    return state;
}

void RunFolder::end(uint64_t claim, const ClaimEnd& end) const
{
    writeFile(file(END + std::to_string(claim)), Json{{"failed", end.failed}, {"line", end.line}}.dump() + "\n");
}

std::string RunFolder::lastLogLine() const
{
    constexpr std::streamoff MOST = 4096;
    std::ifstream file(log(), std::ios::binary | std::ios::ate);
    const std::streamoff size = file.tellg();
    if (!file || size <= 0) return {};
    file.seekg(std::max<std::streamoff>(0, size - MOST));
    return lastLineOf({std::istreambuf_iterator<char>(file), {}});
}

std::string runName(uint64_t number)
{
    return fmt::format("run_{:04}", number);
}

}  // namespace knuckle
