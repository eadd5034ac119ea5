#include "sim/rig/anatomy/facing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "sim/rig/anatomy/names/bone_name.h"

namespace knuckle {

namespace {

constexpr float NAMES = 1.2f;         // weight of names of sides: toes, a face, or two other signs outweigh them
constexpr float SURE = 0.5f;          // the least balance that turns sides without names
constexpr float WORTH_A_NOTE = 1.0f;  // the least weight of contrary signs

/// How names of sides agree with the anatomy: 1 with its sides, -1 with the opposite ones, 0 no names of sides.
int saidSides(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    int sum = 0;
    for (size_t b = 0; b < anatomy.size(); ++b)
        if (anatomy[b].part != BodyPart::Other) sum += anatomy[b].side * readBoneName(model.bones[b].name).side;
    return (sum > 0) - (sum < 0);
}

}  // namespace

bool isFacingKnown(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    return std::abs(readFacing(model, anatomy).balance) >= SURE;
}

void settleSides(const Model& model, std::vector<BoneAnatomy>& anatomy)
{
    const float needed = saidSides(model, anatomy) != 0 ? NAMES : SURE;
    if (readFacing(model, anatomy).balance >= -needed) return;
    for (BoneAnatomy& bone : anatomy) bone.side = -bone.side;
}

std::string facingNote(const Model& model, std::span<const BoneAnatomy> anatomy)
{
    const int said = saidSides(model, anatomy);
    Facing facing = readFacing(model, anatomy);
    if (said > 0) facing.agree.insert(facing.agree.begin(), "names of sides");
    if (said < 0) facing.disagree.insert(facing.disagree.begin(), "names of sides");
    if (facing.against + (said < 0 ? NAMES : 0.0f) < WORTH_A_NOTE) return {};
    const std::string names = said < 0 ? "; what these call left is its right, as one sees it who faces it" : "";
    return fmt::format("The figure looks where {} say, not where {} do{}.", fmt::join(facing.agree, ", "),
                       fmt::join(facing.disagree, ", "), names);
}

}  // namespace knuckle
