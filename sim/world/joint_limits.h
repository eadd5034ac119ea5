#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "sim/world/no_index.h"

namespace knuckle {

struct World;

using Eigen::Vector3f;

enum class JointType : uint32_t { Ball, Hinge, Stiff, Universal };

/// Angles of one axis from the rest pose, right-handed [rad]. The rest pose, 0, belongs to it.
struct TurnRange {
    float lowest = -std::numbers::pi_v<float>;
    float highest = std::numbers::pi_v<float>;
    bool bounded() const { return lowest > -std::numbers::pi_v<float> || highest < std::numbers::pi_v<float>; }
};

/// How far a joint lets body B turn against body A. None by default.
struct JointLimits {
    float swing = std::numbers::pi_v<float>;  ///< Ball: how far B's axis may leave the cone's middle [rad], > 0.
    Vector3f cone{0, 0, 0};  ///< Ball: the cone's middle, A's, in the rest pose; 0: where the axis is at rest.
    TurnRange twist;         ///< Ball: about B's axis.
    TurnRange bend;          ///< Hinge: about its axis. Universal: about that of the hinge at A.
    TurnRange secondBend;    ///< Universal: about that of the hinge at B.
    /// Of the spring behind a limit [N m/rad], > 0; infinity: rigid.
    float stiffness = std::numeric_limits<float>::infinity();

    bool any() const;
    /// The limits that are set and that a joint of this type does not have: "swing".
    std::vector<std::string> misplacedIn(JointType type) const;
};

/// What a joint bears: pulled or turned harder, it tears for good.
struct JointStrength {
    float force = std::numeric_limits<float>::infinity();   ///< [N], > 0.
    float torque = std::numeric_limits<float>::infinity();  ///< Where it holds turns, at its limits too [N m], > 0.
    bool tears() const;
};

/// The limits of a joint between two bodies, as the solver takes them: of a hinge the turn about its axis, of a ball
/// swing and twist (a swing to the axis and a twist about it make every turn).
struct JointBounds {
    uint32_t bodyA = NO_INDEX, bodyB = NO_INDEX;  ///< Of a universal joint, one is its cross.
    Vector3f axis{1, 0, 0};                       ///< B's, in the rest pose of the object, unit.
    Vector3f cone{1, 0, 0};                       ///< A's, the same; unit.
    float swing = std::numbers::pi_v<float>;      ///< [rad]
    TurnRange turn;                               ///< About `axis`.
    float stiffness = std::numeric_limits<float>::infinity();
};

/// The bounds of a joint; none where its limits have none.
/// @param crossBody of a universal joint. @param axis of hinges, of a universal joint that at A. @param along from A to
/// B, the axis of a ball. Unit, perpendicular.
std::vector<JointBounds> boundsOf(JointType type, const JointLimits& limits, uint32_t bodyA, uint32_t bodyB,
                                  uint32_t crossBody, const Vector3f& axis, const Vector3f& along);

/// The part of validate() that is about how far joints turn and what they bear. @throws InputError, std::logic_error.
void validateJoints(const World& world);

}  // namespace knuckle
