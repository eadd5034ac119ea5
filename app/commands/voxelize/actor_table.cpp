#include "app/commands/voxelize/actor_table.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>

#include "app/json/fields.h"
#include "app/run/counted.h"
#include "sim/base/angles.h"
#include "sim/rig/anatomy/names/name_pattern.h"

namespace knuckle {

template <>
struct EnumWords<BodyPart> {
    static constexpr std::array WORDS{"other",     "hips",    "spine", "neck",   "head",  "collar bone",
                                      "upper arm", "forearm", "hand",  "finger", "thigh", "shin",
                                      "foot",      "toe",     "tail",  "wing",   "coxa",  "lever"};
};
template <>
struct EnumWords<AnatomySource> {
    static constexpr std::array WORDS{"", "name", "shape", "clip"};
};

namespace {

constexpr size_t COLUMNS = 7;
using Row = std::array<std::string, COLUMNS>;
using Names = std::vector<std::string>;

/// Facts about a figure's bones for the table, by their names.
class BoneFacts {
public:
    BoneFacts(const Figure& figure, const ArticulationOptions& options) : options_(options), figure_(figure)
    {
        const std::vector<Bone>& bones = figure.model.bones;
        for (uint32_t b = 0; b < bones.size(); ++b) bones_.try_emplace(bones[b].name, b);
    }

    /// "upper arm, left (name)"
    std::string part(const std::string& name) const
    {
        const auto bone = find(name);
        if (!bone) return {};
        if (figure_.model.isSplit) return "part";
        const BoneAnatomy& anatomy = figure_.anatomy[*bone];
        const char* side = anatomy.side > 0 ? ", left" : anatomy.side < 0 ? ", right" : "";
        Names by;
        if (anatomy.source != AnatomySource::None) by.push_back(wordOf(anatomy.source));
        if (figure_.wanted.contains(*bone)) by.push_back("--keep");
        if (isOverridden(name)) by.push_back("--joints");
        return wordOf(anatomy.part) + side + (by.empty() ? "" : fmt::format(" ({})", fmt::join(by, ", ")));
    }

private:
    std::optional<uint32_t> find(const std::string& name) const
    {
        const auto found = bones_.find(name);
        return found == bones_.end() ? std::nullopt : std::optional(found->second);
    }
    bool isOverridden(const std::string& name) const
    {
        return findByPattern(options_.types, name) || findByPattern(options_.axes, name) ||
               findByPattern(options_.limits, name) || findByPattern(options_.strengths, name);
    }

    const ArticulationOptions& options_;
    const Figure& figure_;
    std::map<std::string, uint32_t> bones_;
};

long degrees(float radians)
{
    return std::lround(degreesOf(radians));
}

std::string rangeText(const TurnRange& range)
{
    return range.bounded() ? fmt::format("{} to {}", degrees(range.lowest), degrees(range.highest)) : "all round";
}

/// "x", "-z", or its numbers if it is not one of the world's axes.
std::string axisText(const Vector3f& axis)
{
    constexpr float ALONG = 0.9995f;  // a little less than 2 degrees off
    for (int k = 0; k < 3; ++k)
        if (std::abs(axis[k]) > ALONG) return fmt::format("{}{}", axis[k] < 0.0f ? "-" : "", "xyz"[k]);
    const auto rounded = [&](int k) { return std::round(axis[k] * 100.0f) / 100.0f + 0.0f; };
    return fmt::format("({:.2f} {:.2f} {:.2f})", rounded(0), rounded(1), rounded(2));
}

std::string turnText(const ActorJoint& joint)
{
    const JointLimits& limits = joint.limits;
    std::string text;
    switch (joint.type) {
        case JointType::Stiff: return "-";
        case JointType::Hinge:
        case JointType::Universal:
            text = fmt::format("{} about {}", rangeText(limits.bend), axisText(joint.axis));
            break;
        case JointType::Ball:
            if (!limits.any()) return "any way";
            text = limits.swing < HALF_TURN ? fmt::format("cone {}", degrees(limits.swing)) : "any way";
            text += ", twist " + rangeText(limits.twist);
    }
    if (std::isfinite(limits.stiffness)) text += fmt::format(", spring {:.3g} N m/rad", limits.stiffness);
    return text;
}

Row bodyRow(const Actor& actor, const BoneFacts& facts, uint32_t index)
{
    const ActorBody& body = actor.bodies[index];
    Row row{body.name,
            body.parent < 0 ? "-" : actor.bodies[static_cast<size_t>(body.parent)].name,
            std::to_string(body.particles.size()),
            "-",
            "-",
            "-",
            body.isCross ? "middle of a universal joint" : facts.part(body.name)};
    for (const ActorJoint& joint : actor.joints) {
        if (joint.child != index) continue;
        row[3] = wordOf(joint.type);
        row[4] = std::to_string(joint.sharedParticles.size());
        row[5] = turnText(joint);
    }
    return row;
}

std::string aligned(const std::vector<Row>& rows)
{
    constexpr std::array NUMBERS{false, false, true, false, true, false, false};
    std::array<size_t, COLUMNS> widths{};
    for (const Row& row : rows)
        for (size_t c = 0; c < COLUMNS; ++c) widths[c] = std::max(widths[c], row[c].size());
    std::string text;
    for (const Row& row : rows) {
        std::string line;
        for (size_t c = 0; c < COLUMNS; ++c)
            line += NUMBERS[c] ? fmt::format("{:>{}}  ", row[c], widths[c])
                               : fmt::format("{:<{}}  ", row[c], widths[c]);
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string sizeText(const Model& model)
{
    Eigen::AlignedBox3f box;
    for (const Vector3f& vertex : model.vertices) box.extend(vertex);
    const Vector3f size = box.sizes();
    const float lowest = std::round(box.min().y() * 1000.0f) / 1000.0f + 0.0f;
    return fmt::format("size: {:.3g} m wide, {:.3g} high, {:.3g} deep; its lowest point at a height of {:.3g} m\n",
                       size.x(), size.y(), size.z(), lowest);
}

std::string clipText(const Model& model)
{
    std::string text;
    for (const Clip& clip : model.clips) text += fmt::format("clip: {}, {:.2f} s\n", clip.name, clip.duration);
    for (const UnusableClip& clip : model.unusableClips) text += fmt::format("clip: {} {}\n", clip.name, clip.why);
    return text;
}

}  // namespace

std::string actorTable(const Actor& actor, const Figure& figure, const ArticulationOptions& options,
                       const FillError& fill)
{
    const Model& model = figure.model;
    const BoneFacts facts(figure, options);
    std::vector<Row> rows{{"body", "parent", "particles", "joint", "shared", "turns, degrees", "taken for (by)"}};
    size_t mergedCount = 0;
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        rows.push_back(bodyRow(actor, facts, b));
        mergedCount += actor.bodies[b].mergedBones.size();
    }
    std::string text = aligned(rows);
    text += fmt::format("\n{}: {} of {} m, {}, {}, {} merged\n", actor.name.empty() ? "actor" : actor.name,
                        counted(actor.particles.size(), "particle"), actor.diameter,
                        counted(actor.bodies.size(), "body", "bodies"), counted(actor.joints.size(), "joint"),
                        counted(mergedCount, "bone"));
    text += sizeText(model);
    const std::string share = std::isfinite(fill.volume)
                                  ? fmt::format("{:.0f} % of the mesh's volume", 100 * fill.volume)
                                  : "the mesh encloses no volume";
    text += fmt::format("fill: {}; its surface is {:.2f} diameters off the particles'\n", share, fill.surface);
    text += fmt::format("pose: {}\n", model.poseFrom.empty() ? "the file's rest pose" : model.poseFrom);
    text += clipText(model);
    for (const std::string& note : actor.notes) text += fmt::format("note: {}\n", note);
    for (const Clip& clip : model.clips)
        for (const std::string& note : clip.notes) text += fmt::format("note: {}\n", note);
    for (const std::string& what : model.surface.missing) text += fmt::format("note: {}\n", what);
    for (const std::string& note : model.surface.notes) text += fmt::format("note: {}\n", note);
    return text;
}

}  // namespace knuckle
