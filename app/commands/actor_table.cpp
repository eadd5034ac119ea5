#include "app/commands/actor_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "app/json/fields.h"
#include "app/run/counted.h"

namespace knuckle {

namespace {

using Row = std::array<std::string, 6>;

/// The first name and how many more there are; the notes below the table have them all.
std::string shortList(const std::vector<std::string>& names)
{
    if (names.size() <= 2) return fmt::format("{}", fmt::join(names, ", "));
    return fmt::format("{} and {} more", names.front(), names.size() - 1);
}

Row bodyRow(const Actor& actor, uint32_t index)
{
    const ActorBody& body = actor.bodies[index];
    Row row{body.name,
            body.parent < 0 ? "-" : actor.bodies[static_cast<size_t>(body.parent)].name,
            std::to_string(body.particles.size()),
            "-",
            "-",
            shortList(body.mergedBones)};
    for (const ActorJoint& joint : actor.joints) {
        if (joint.child != index) continue;
        row[3] = wordOf(joint.type);
        row[4] = std::to_string(joint.sharedParticles.size());
    }
    return row;
}

}  // namespace

std::string actorTable(const Actor& actor)
{
    std::vector<Row> rows{{"body", "parent", "particles", "joint", "shared", "merged bones"}};
    size_t mergedCount = 0;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        rows.push_back(bodyRow(actor, b));
        mergedCount += actor.bodies[b].mergedBones.size();
    }
    std::array<size_t, 6> widths{};
    for (const Row& row : rows) {
        for (size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
    }
    std::string text;
    for (const Row& row : rows) {
        std::string line = fmt::format("{:<{}}  {:<{}}  {:>{}}  {:<{}}  {:>{}}  {}", row[0], widths[0], row[1],
                                       widths[1], row[2], widths[2], row[3], widths[3], row[4], widths[4], row[5]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    text += fmt::format("\n{}: {} of {} m, {}, {}, {} merged\n", actor.name.empty() ? "actor" : actor.name,
                        counted(actor.particles.size(), "particle"), actor.diameter,
                        counted(actor.bodies.size(), "body", "bodies"), counted(actor.joints.size(), "joint"),
                        counted(mergedCount, "bone"));
    for (const std::string& note : actor.notes) text += fmt::format("note: {}\n", note);
    return text;
}

std::string clipTable(const Model& model)
{
    std::string text;
    for (const Clip& clip : model.clips) text += fmt::format("clip: {}, {:.2f} s\n", clip.name, clip.duration);
    for (const UnusableClip& clip : model.unusableClips) text += fmt::format("clip: {} {}\n", clip.name, clip.why);
    return text;
}

}  // namespace knuckle
