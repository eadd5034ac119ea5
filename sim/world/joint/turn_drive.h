#pragma once

#include <cmath>
#include <limits>

namespace knuckle {

/// Turns a joint's child against its parent: a spring and a damper about the axes that the joint leaves free, whose
/// torque is bounded where it is a motor's.
struct TurnDrive {
    float stiffness = 0.0f;  ///< [N m/rad], >= 0.
    float damping = 0.0f;    ///< [N m s/rad], >= 0.
    float angle = 0.0f;      ///< Of a hinge, against its start, where it is at rest; whole turns count [rad].
    float speed = 0.0f;      ///< Of a hinge, at which it does not damp [rad/s].
    float greatestTorque = std::numeric_limits<float>::infinity();  ///< [N m], > 0; infinity: of a spring.
    float greatestSpeed = std::numeric_limits<float>::infinity();   ///< At which it turns to its angle [rad/s], > 0.

    bool acts() const { return stiffness > 0.0f || damping > 0.0f; }
    bool isMotor() const { return std::isfinite(greatestTorque); }
    /// Whether it needs one axis.
    bool needsHinge() const { return acts() && (isMotor() || angle != 0.0f || speed != 0.0f); }
};

/// Turns a hinge at a speed [rad/s]. @param torque with which it gets there and stays there, > 0 [N m]: a load of as
/// much slows it by a hundredth.
TurnDrive speedMotor(float speed, float torque);
/// Turns a hinge to an angle and holds it there [rad]. @param torque > 0 [N m]: a load of as much turns it by a degree.
/// @param speed at which it turns there, > 0 [rad/s].
TurnDrive angleMotor(float angle, float torque, float speed = std::numeric_limits<float>::infinity());

}  // namespace knuckle
