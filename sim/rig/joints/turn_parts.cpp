#include "sim/rig/joints/turn_parts.h"

#include <cmath>

#include "sim/base/angles.h"
#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

constexpr float UNSURE = 0.35f;  // cosine of half the swing below which the turn about an axis is undetermined

float middleOf(const TurnRange& range)
{
    return range.bounded() ? 0.5f * (range.lowest + range.highest) : 0.0f;
}

}  // namespace

float turnAbout(const Vector3f& axis, const Quaternionf& turn)
{
    return std::remainder(2 * std::atan2(turn.vec().dot(axis), turn.w()), WHOLE_TURN);
}

bool isSureAbout(const Vector3f& axis, const Quaternionf& turn)
{
    return std::hypot(turn.w(), turn.vec().dot(axis)) >= UNSURE;
}

TurnReader::TurnReader(const JointLimits& limits, JointType type, const Vector3f& axis)
    : isBall_(type == JointType::Ball), axis_(axis), range_(isBall_ ? limits.twist : limits.bend),
      last_(middleOf(range_))
{
    if (isBall_ && !limits.cone.isZero()) lean_ = turnBetween(axis, limits.cone.normalized());
}

float TurnReader::follow(float angle) const
{
    // Brings an angle that went round back into its range.
    const float home = middleOf(range_) + std::remainder(angle - middleOf(range_), WHOLE_TURN);
    if (range_.bounded() && home >= range_.lowest && home <= range_.highest) return home;
    return last_ + std::remainder(angle - last_, WHOLE_TURN);
}

TurnParts TurnReader::read(const Quaternionf& turn)
{
    const Quaternionf leaned = lean_.conjugate() * turn;
    TurnParts parts;
    parts.isTwistSure = isSureAbout(axis_, leaned);
    if (parts.isTwistSure) last_ = follow(turnAbout(axis_, leaned));
    parts.twist = last_;
    if (!isBall_) return parts;
    const Vector3f now = leaned * axis_, across = axis_.cross(now);
    parts.swing = std::atan2(across.norm(), axis_.dot(now));
    parts.about = across.norm() > 1e-6f ? Vector3f(across.normalized()) : axis_.unitOrthogonal();
    return parts;
}

Quaternionf TurnReader::turnOf(const TurnParts& parts) const
{
    Quaternionf twist(Eigen::AngleAxisf(parts.twist, axis_));
    if (!isBall_) return twist;
    return lean_ * Quaternionf(Eigen::AngleAxisf(parts.swing, parts.about)) * twist;
}

}  // namespace knuckle
