#pragma once

#include "sim/base/angles.h"
#include "sim/world/joint/joint.h"
#include "sim/world/space/pose.h"

namespace knuckle {

/// How far limits extend beyond clips and the rest pose [rad].
inline constexpr float LIMIT_SPARE = 5 * HALF_TURN / 180;

/// The angle of a turn about an axis, within half a turn either way [rad]. @param axis unit.
float turnAbout(const Vector3f& axis, const Quaternionf& turn);

/// Whether that angle is determined: it is not if the axis swings by nearly half a turn.
bool isSureAbout(const Vector3f& axis, const Quaternionf& turn);

/// A joint's turn in terms of its limits: for a ball, first about the axis, then a swing of the axis; for a hinge only
/// the former.
struct TurnParts {
    float swing = 0.0f;       ///< Of a ball's axis from the middle of its cone [rad].
    Vector3f about{0, 0, 0};  ///< The axis of the swing, unit.
    float twist = 0.0f;       ///< About the axis [rad]; continues beyond half a turn over keys.
    bool isTwistSure = true;  ///< Otherwise it is that of the key before.
};

/// Takes turns apart, key after key.
class TurnReader {
public:
    /// @param type hinge or ball. @param axis of the joint in the rest pose, unit.
    TurnReader(const JointLimits& limits, JointType type, const Vector3f& axis);

    /// @param turn of the child against its parent, from the rest pose.
    TurnParts read(const Quaternionf& turn);
    /// The turn that has these parts.
    Quaternionf turnOf(const TurnParts& parts) const;

private:
    /// The continuous angle for a key whose angle within half a turn is given.
    float follow(float angle) const;

    bool isBall_;
    Vector3f axis_;
    Quaternionf lean_{1, 0, 0, 0};  ///< From the axis to the middle of the cone.
    TurnRange range_;
    float last_;  ///< Twist of the key before [rad].
};

}  // namespace knuckle
