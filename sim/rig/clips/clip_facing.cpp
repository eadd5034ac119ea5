#include "sim/rig/clips/clip_facing.h"

#include <cmath>

#include "sim/rig/anatomy/facing.h"

namespace knuckle {

namespace {

Quaternionf facingFrom(const Vector3f& theirLeft, const Vector3f& ourLeft)
{
    const float yaw = std::atan2(theirLeft.z(), theirLeft.x()) - std::atan2(ourLeft.z(), ourLeft.x());
    return Quaternionf(Eigen::AngleAxisf(yaw, Vector3f::UnitY()));
}

}  // namespace

Quaternionf facingOf(const ActorAnatomy& actor, const Figure& source, const std::vector<uint32_t>& bones)
{
    const std::vector<BoneAnatomy>& theirs = source.anatomy;
    int alike = 0;
    for (size_t body = 0; body < bones.size(); ++body)
        if (bones[body] != NO_INDEX) alike += theirs[bones[body]].side * actor.bones[body].side;
    // Of two skeletons with the same names, perhaps only one is known to have its sides swapped.
    const bool turned = alike < 0 && !(actor.isFacingKnown && isFacingKnown(source.model, theirs));
    return facingFrom(turned ? Vector3f(-source.left) : source.left, leftOf(actor.skeleton, actor.bones));
}

}  // namespace knuckle
