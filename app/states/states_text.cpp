#include "app/states/states_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace knuckle {

namespace {

std::string megabytes(uint64_t bytes)
{
    return fmt::format("{:.2f} MB", 1e-6 * static_cast<double>(bytes));
}

}  // namespace

std::string framesText(const std::vector<uint64_t>& frames)
{
    if (frames.empty()) return "none";
    const bool gapless = frames.back() - frames.front() + 1 == frames.size();
    if (gapless && frames.size() > 2) return fmt::format("{} to {}", frames.front(), frames.back());
    return fmt::format("{}", fmt::join(frames, ", "));
}

std::string statesText(const StatesFile& states)
{
    const RunFacts& facts = states.facts();
    const RunFingerprint& print = facts.fingerprint;
    uint64_t frames = 0, whole = 0;
    for (const BlockReader::Block& block : states.blocks().list()) {
        if (block.name.starts_with("frame ")) frames += block.stored;
        if (block.name.starts_with("state ")) whole += block.stored;
    }
    std::vector<std::string> changes;
    for (const Override& change : facts.source.changes)
        changes.push_back(fmt::format(" --set {}={}", change.path, change.value.dump()));
    std::string text = fmt::format("{}: states of the scene \"{}\"\n", states.path(), facts.sceneName);
    const auto line = [&](const char* word, const std::string& value) {
        text += fmt::format("  {:<14}{}\n", word, value);
    };
    line("scene", facts.source.file + fmt::format("{}", fmt::join(changes, "")));
    line("time", fmt::format("{} frames a second, {} steps a frame", facts.framesPerSecond, facts.stepsPerFrame));
    line("particles", fmt::format("{} of {:.4g} m; {} bodies", facts.particles, facts.diameter, facts.bodies));
    line("frames", fmt::format("{}, {}", framesText(states.frames()), megabytes(frames)));
    line("whole states", fmt::format("{}, {}", framesText(states.states()), megabytes(whole)));
    line("program", fmt::format("{}, build {}, shaders {}", print.program, print.build, print.shaders));
    line("device", fmt::format("{}, {}", print.device, print.driver));
    line("world", print.world);
    return text;
}

}  // namespace knuckle
