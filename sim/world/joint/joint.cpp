#include "sim/world/joint/joint.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/base/angles.h"
#include "sim/base/errors.h"
#include "sim/world/joint/joint_order.h"
#include "sim/world/world.h"

namespace knuckle {

namespace {

constexpr float FREE = HALF_TURN;
/// A narrower cone would be a hinge along the axis. [rad]
constexpr float LEAST_SWING = 0.999f * FREE / 180;

/// @returns what is wrong with a joint's limits; empty if nothing is.
std::string faultOf(const Joint& joint)
{
    const TurnLimits& limits = joint.limits;
    const TurnRange& twist = limits.twist;
    if (!(twist.lowest <= 0 && twist.highest >= 0 && twist.lowest >= -FREE && twist.highest <= FREE))
        return fmt::format("the turn from {:g} to {:g} degrees must be within -180 to 180 and contain 0, the rest pose",
                           degreesOf(twist.lowest), degreesOf(twist.highest));
    if (!(limits.swing >= LEAST_SWING && limits.swing <= FREE))
        return fmt::format("a swing of {:g} degrees must be 1 to 180; use a hinge for less", degreesOf(limits.swing));
    const Vector3f axis = joint.childSide.frame * Vector3f::UnitX(),
                   cone = joint.turn.conjugate() * (joint.parentSide.frame * Vector3f::UnitX());
    const float leaning = std::acos(std::clamp(axis.dot(cone), -1.0f, 1.0f));
    if (limits.swing < FREE && leaning > limits.swing + 1e-3f)
        return fmt::format("at rest the axis leaves the middle of its cone by {:.3g} degrees, more than the swing of "
                           "{:g}; turn the cone or widen it",
                           degreesOf(leaning), degreesOf(limits.swing));
    if (!(limits.stiffness > 0)) return fmt::format("a stiffness of {} N m/rad must be above 0", limits.stiffness);
    return {};
}

/// @returns what is wrong with a joint's drive; empty if nothing is.
std::string driveFaultOf(const World& world, const Joint& joint)
{
    const TurnDrive& drive = joint.drive;
    const auto isGiven = [](float value) { return std::isfinite(value) && value >= 0; };
    if (!isGiven(drive.stiffness) || !isGiven(drive.damping))
        return fmt::format("a stiffness of {} N m/rad and a damping of {} N m s/rad must be 0 or more", drive.stiffness,
                           drive.damping);
    if (!std::isfinite(drive.angle) || !std::isfinite(drive.speed)) return "its angle and its speed must be finite";
    if (!(drive.greatestTorque > 0 && drive.greatestSpeed > 0))
        return fmt::format("a torque of {} N m and a speed of {} rad/s must be above 0", drive.greatestTorque,
                           drive.greatestSpeed);
    if (!drive.acts()) return {};
    const char* name = drive.isMotor() ? "motor" : "spring";
    if (world.settings.solver == SolverKind::Paper)
        return fmt::format("the paper's solver has no {}s; take it away, or use solver method impulse", name);
    if (joint.type == JointType::Stiff || (drive.needsHinge() && joint.type != JointType::Hinge))
        return fmt::format("its {} needs a joint that turns so; use a hinge", name);
    if (neverResponds(world.bodies[joint.parent]) && neverResponds(world.bodies[joint.child]))
        return fmt::format("its {} has nothing to turn, since both bodies are fixed; free one of them", name);
    return {};
}

bool hasLink(const World& world, uint32_t body, uint32_t particle)
{
    const auto first = world.links.begin() + world.bodies[body].linkStart;
    return std::any_of(first, first + world.bodies[body].linkCount,
                       [&](const Link& link) { return link.particle == particle; });
}

bool isValid(const JointSide& side)
{
    return side.arm.allFinite() && std::abs(side.frame.norm() - 1.0f) < 1e-3f;
}

/// Sharing particles is what holds bodies together: the record must match it.
void validateRecord(const World& world, const Joint& joint)
{
    const auto require = [&](bool holds, const char* what) {
        if (!holds) throw std::logic_error(fmt::format("the joint \"{}\": {}", joint.name, what));
    };
    require(joint.parent != joint.child && std::max(joint.parent, joint.child) < world.bodies.size(),
            "it needs two different bodies that exist");
    require(!joint.particles.empty() && std::ranges::is_sorted(joint.particles), "it needs particles, in order");
    require(joint.type != JointType::Universal, "a universal joint is two hinges");
    require(isValid(joint.parentSide) && isValid(joint.childSide), "its arms and frames must be finite");
    for (const uint32_t particle : joint.particles)
        require(hasLink(world, joint.parent, particle) && hasLink(world, joint.child, particle),
                "its particles must belong to both bodies");
}

/// Checks that joints with it connect all bodies of each shared particle.
void validateCover(const World& world)
{
    SharedParticles covered;
    std::vector<uint32_t> groups;
    for (const Particle& p : world.particles) groups.push_back(p.bodyCount);
    for (const Joint& joint : world.joints)
        for (const uint32_t particle : joint.particles)
            if (covered.connect(particle, joint.parent, joint.child)) --groups[particle];
    for (size_t i = 0; i < groups.size(); ++i)
        if (groups[i] > 1) throw std::logic_error(fmt::format("particle {} is shared without a joint", i));
}

}  // namespace

std::pair<JointLimits, JointLimits> hingeLimits(const JointLimits& universal)
{
    JointLimits first = universal, second = universal;
    second.bend = universal.secondBend;
    first.secondBend = second.secondBend = {};
    return {first, second};
}

bool JointLimits::any() const
{
    return swing < FREE || twist.bounded() || bend.bounded() || secondBend.bounded();
}

bool JointStrength::tears() const
{
    return std::min({force, torque, time}) < std::numeric_limits<float>::infinity();
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

void setLimits(JointDraft& draft, const JointLimits& limits, const Vector3f& axis)
{
    TurnLimits& out = draft.joint.limits;
    if (draft.joint.type == JointType::Ball) out = {limits.swing, limits.twist, limits.stiffness};
    if (draft.joint.type == JointType::Hinge) out = {FREE, limits.bend, limits.stiffness};
    if (!draft.joint.countsAngles()) return;
    draft.axis = draft.cone = axis;
    if (draft.joint.type == JointType::Ball && !limits.cone.isZero()) draft.cone = limits.cone.normalized();
}

bool hasLimits(const World& world)
{
    return std::ranges::any_of(world.joints, [](const Joint& joint) { return joint.limits.any(); });
}

size_t jointCount(const World& world)
{
    return world.joints.size() - static_cast<size_t>(std::ranges::count_if(world.bodies, &Body::isCross));
}

void validateJoints(const World& world)
{
    const bool paper = world.settings.solver == SolverKind::Paper;
    for (const Joint& joint : world.joints) {
        validateRecord(world, joint);
        const JointStrength& strength = joint.strength;
        if (!(strength.force > 0 && strength.torque > 0))
            throw InputError(fmt::format("the joint \"{}\": a strength of {} N and {} N m must be above 0", joint.name,
                                         strength.force, strength.torque));
        if (!(strength.time > 0))
            throw InputError(fmt::format("the joint \"{}\": the time at which it lets go, {} s, must be above 0",
                                         joint.name, strength.time));
        if (paper && strength.tears())
            throw InputError("the paper's solver has no joints that tear; take `tearForce`, `tearTorque` and "
                             "`releaseTime` away, or use solver method impulse");
        if (paper && joint.limits.any())
            throw InputError("the paper's solver has no joint limits; take them away, or use solver method impulse");
        if (const std::string fault = faultOf(joint); !fault.empty())
            throw InputError(fmt::format("the joint of \"{}\" and \"{}\": {}", world.bodies[joint.parent].name,
                                         world.bodies[joint.child].name, fault));
        if (const std::string fault = driveFaultOf(world, joint); !fault.empty())
            throw InputError(fmt::format("the joint \"{}\": {}", joint.name, fault));
    }
    validateCover(world);
    for (const LoopJoint& loop : orderJoints(world).loops) {
        const Joint& joint = world.joints[loop.joint];
        if (joint.limits.any())
            throw InputError(fmt::format("the joint of \"{}\" and \"{}\" closes a loop of joints with limits, which "
                                         "cannot be; leave one joint of the loop without",
                                         world.bodies[joint.parent].name, world.bodies[joint.child].name));
        if (joint.turns())
            throw InputError(
                fmt::format("the joint \"{}\" closes a loop of joints with motors, springs, gears or limits, "
                            "which cannot be; leave one joint of the loop without",
                            joint.name));
    }
}

}  // namespace knuckle
