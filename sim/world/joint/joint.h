#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "sim/base/angles.h"
#include "sim/base/no_index.h"
#include "sim/world/joint/turn_drive.h"

namespace knuckle {

struct World;

using Eigen::Quaternionf;
using Eigen::Vector3f;

enum class JointType : uint32_t { Ball, Hinge, Stiff, Universal };

/// Angles about one axis from the rest pose, right-handed [rad]. They include the rest pose, 0.
struct TurnRange {
    float lowest = -HALF_TURN;
    float highest = HALF_TURN;
    bool bounded() const { return lowest > -HALF_TURN || highest < HALF_TURN; }
};

/// How far a joint lets its child turn against its parent, in terms of its type. No limits by default.
struct JointLimits {
    float swing = HALF_TURN;  ///< Ball: how far the child's axis may leave the cone's middle [rad], > 0.
    Vector3f cone{0, 0, 0};   ///< Ball: the middle of the cone, fixed in the parent, in the rest pose; 0: the axis at
                              ///< rest.
    TurnRange twist;          ///< Ball: about the child's axis.
    TurnRange bend;           ///< Hinge: about its axis. Universal: about that of the hinge at the parent.
    TurnRange secondBend;     ///< Universal: about that of the hinge at the child.
    /// Of the spring behind a limit [N m/rad], > 0; infinity: rigid.
    float stiffness = std::numeric_limits<float>::infinity();

    bool any() const;
    /// The limits that are set although a joint of this type does not have them: "swing".
    std::vector<std::string> misplacedIn(JointType type) const;
};

/// The limits of a universal joint's two hinges, at the parent and at the child.
std::pair<JointLimits, JointLimits> hingeLimits(const JointLimits& universal);

/// Limits of any joint in the solver's form: how far x of the child's frame may leave x of the parent's, and how far
/// the child may turn about it (a swing of the axis and a twist about it make up any turn). A hinge only has the twist.
struct TurnLimits {
    float swing = HALF_TURN;  ///< [rad]
    TurnRange twist;
    float stiffness = std::numeric_limits<float>::infinity();  ///< [N m/rad], > 0; infinity: rigid.
    bool any() const { return swing < HALF_TURN || twist.bounded(); }
};

/// The load that a joint bears, and for how long: beyond either, the joint tears for good.
struct JointStrength {
    float force = std::numeric_limits<float>::infinity();   ///< [N], > 0.
    float torque = std::numeric_limits<float>::infinity();  ///< In directions in which it holds turns, including its
                                                            ///< limits [N m], > 0.
    float time = std::numeric_limits<float>::infinity();    ///< When it lets go whatever it bears [s], > 0.
    bool tears() const;
};

/// Where a joint is in one of its bodies, in the body's axes.
struct JointSide {
    Vector3f arm{0, 0, 0};  ///< From the body's centre to the middle of the shared particles [m].
    Quaternionf frame{1, 0, 0,
                      0};  ///< From the joint's axes; a hinge turns about x. Both sides agree at rest, unless a cone
                           ///< leans.
};

/// Two bodies that share particles, which hold them together (paper, section 4): the record of it. A universal joint is
/// two hinges, one on each side of its cross (Body::isCross).
struct Joint {
    std::string name;
    JointType type = JointType::Ball;  ///< How its particles let it turn: as a ball, a hinge, or not at all.
    uint32_t parent = NO_INDEX, child = NO_INDEX;
    std::vector<uint32_t> particles = {};  ///< That both bodies share, ascending.
    JointSide parentSide = {}, childSide = {};
    TurnLimits limits = {};
    JointStrength strength = {};
    Quaternionf turn{1, 0, 0, 0};  ///< At rest, from the child's axes to the parent's; bodies of one object share them.
    TurnDrive drive = {};
    bool geared = false;  ///< Whether gears may turn it (World::gears).

    /// Whether its axes have a direction: limits, drives and gears count angles about them.
    bool countsAngles() const { return limits.any() || turns(); }
    /// Whether something beside its limits turns it.
    bool turns() const { return drive.acts() || geared; }
    bool connects(uint32_t a, uint32_t b) const { return std::minmax(a, b) == std::minmax(parent, child); }
};

/// A joint as described, before its bodies have links.
struct JointDraft {
    Joint joint;
    /// For limits: the child's axis and the middle of the parent's cone, in the child's axes at rest, unit.
    Vector3f axis{0, 0, 0}, cone{0, 0, 0};
};

/// Sets a joint's limits from those of its type, and its axes, after its drive. @param axis of a hinge, or a ball's
/// child's; unit, in the rest pose.
void setLimits(JointDraft& draft, const JointLimits& limits, const Vector3f& axis);

/// Whether any joint of a world is limited.
bool hasLimits(const World& world);

/// The number of joints in a world; a universal joint counts once.
size_t jointCount(const World& world);

/// Validates joints. @throws InputError, std::logic_error.
void validateJoints(const World& world);

}  // namespace knuckle
