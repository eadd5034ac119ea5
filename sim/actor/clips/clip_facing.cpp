#include "sim/actor/clips/clip_facing.h"

#include <cmath>

#include "sim/actor/anatomy/facing.h"
#include "sim/actor/clips/bone_match.h"

namespace knuckle {

namespace {

Quaternionf facingFrom(const Vector3f& theirLeft, const Vector3f& ourLeft)
{
    const float yaw = std::atan2(theirLeft.z(), theirLeft.x()) - std::atan2(ourLeft.z(), ourLeft.x());
    return Quaternionf(Eigen::AngleAxisf(yaw, Vector3f::UnitY()));
}

}  // namespace

Quaternionf facingOf(const Actor& actor, const Model& source, const std::vector<uint32_t>& bones)
{
    const std::vector<BoneAnatomy> theirs = readAnatomy(source);
    const ActorAnatomy ours = anatomyOf(actor);
    int alike = 0;
    for (size_t body = 0; body < bones.size(); ++body)
        if (bones[body] != NO_INDEX) alike += theirs[bones[body]].side * ours.bones[body].side;
    // Of two skeletons with the same names only one may be known to have its sides the other way round.
    const bool turned = alike < 0 && !(ours.isFacingKnown && isFacingKnown(source, theirs));
    const Vector3f left = leftOf(source, theirs);
    return facingFrom(turned ? Vector3f(-left) : left, leftOf(skeletonOf(actor), ours.bones));
}

}  // namespace knuckle
