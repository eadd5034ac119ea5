#include "sim/world/joint_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/world/errors.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

constexpr float FREE = std::numbers::pi_v<float>;
/// A narrower cone is a hinge along the axis. [rad]
constexpr float LEAST_SWING = 0.999f * FREE / 180;

float degrees(float radians)
{
    return radians * 180 / FREE;
}

bool isUnit(const Vector3f& v)
{
    return std::abs(v.norm() - 1.0f) < 1e-3f;
}

/// @returns what is wrong with a joint's limits; empty where nothing is.
std::string faultOf(const JointBounds& bounds)
{
    const TurnRange& turn = bounds.turn;
    if (!(turn.lowest <= 0 && turn.highest >= 0 && turn.lowest >= -FREE && turn.highest <= FREE))
        return fmt::format("the turn from {:g} to {:g} degrees must be within -180 to 180 and contain 0, the rest pose",
                           degrees(turn.lowest), degrees(turn.highest));
    if (!(bounds.swing >= LEAST_SWING && bounds.swing <= FREE))
        return fmt::format("a swing of {:g} degrees must be 1 to 180; use a hinge for less", degrees(bounds.swing));
    const float leaning = std::acos(std::clamp(bounds.axis.dot(bounds.cone), -1.0f, 1.0f));
    if (leaning > bounds.swing + 1e-3f)
        return fmt::format("at rest the axis leaves the middle of its cone by {:.3g} degrees, more than the swing of "
                           "{:g}; turn the cone or widen it",
                           degrees(leaning), degrees(bounds.swing));
    if (!(bounds.stiffness > 0)) return fmt::format("a stiffness of {} N m/rad must be above 0", bounds.stiffness);
    return {};
}

}  // namespace

bool JointLimits::any() const
{
    return swing < FREE || twist.bounded() || bend.bounded() || secondBend.bounded();
}

bool JointStrength::tears() const
{
    return std::min(force, torque) < std::numeric_limits<float>::infinity();
}

std::vector<std::string> JointLimits::misplacedIn(JointType type) const
{
    const bool isBall = type == JointType::Ball, isUniversal = type == JointType::Universal;
    const bool isHinge = type == JointType::Hinge || isUniversal;
    std::vector<std::string> misplaced;
    const auto check = [&](const char* name, bool isSet, bool has) {
        if (isSet && !has) misplaced.push_back(name);
    };
    check("swing", swing < FREE, isBall);
    check("cone", !cone.isZero(), isBall);
    check("twist", twist.bounded(), isBall);
    check("bend", bend.bounded(), isHinge);
    check("secondBend", secondBend.bounded(), isUniversal);
    return misplaced;
}

std::vector<JointBounds> boundsOf(JointType type, const JointLimits& limits, uint32_t bodyA, uint32_t bodyB,
                                  uint32_t crossBody, const Vector3f& axis, const Vector3f& along)
{
    std::vector<JointBounds> bounds;
    const auto add = [&](uint32_t a, uint32_t b, const Vector3f& about, const TurnRange& turn) {
        bounds.push_back({a, b, about, about, FREE, turn, limits.stiffness});
    };
    switch (type) {
        case JointType::Ball:
            if (limits.swing == FREE && !limits.twist.bounded()) break;
            add(bodyA, bodyB, along, limits.twist);
            bounds.back().swing = limits.swing;
            if (!limits.cone.isZero()) bounds.back().cone = limits.cone.normalized();
            break;
        case JointType::Hinge:
            if (limits.bend.bounded()) add(bodyA, bodyB, axis, limits.bend);
            break;
        case JointType::Universal:
            if (limits.bend.bounded()) add(bodyA, crossBody, axis, limits.bend);
            if (limits.secondBend.bounded()) add(crossBody, bodyB, along.cross(axis), limits.secondBend);
            break;
        case JointType::Stiff: break;
    }
    return bounds;
}

void validateJoints(const World& world)
{
    for (const Joint& joint : world.joints) {
        const JointStrength& strength = joint.strength;
        if (!(strength.force > 0 && strength.torque > 0))
            throw InputError(fmt::format("the joint \"{}\": a strength of {} N and {} N m must be above 0", joint.name,
                                         strength.force, strength.torque));
        if (strength.tears() && world.settings.solver == SolverKind::Paper)
            throw InputError("the paper's solver has no joints that tear; take `tearForce` and `tearTorque` away, or "
                             "use solver method impulse");
    }
    if (!world.jointBounds.empty() && world.settings.solver == SolverKind::Paper)
        throw InputError("the paper's solver has no joint limits; take them away, or use solver method impulse");
    for (const JointBounds& bounds : world.jointBounds) {
        if (bounds.bodyA == bounds.bodyB || std::max(bounds.bodyA, bounds.bodyB) >= world.bodies.size())
            throw std::logic_error("joint bounds are between two bodies that exist");
        if (!isUnit(bounds.axis) || !isUnit(bounds.cone))
            throw std::logic_error("joint bounds have an axis and a cone of length 1");
        if (const std::string fault = faultOf(bounds); !fault.empty())
            throw InputError(fmt::format("the joint of \"{}\" and \"{}\": {}", world.bodies[bounds.bodyA].name,
                                         world.bodies[bounds.bodyB].name, fault));
    }
}

}  // namespace knuckle
