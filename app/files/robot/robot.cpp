#include "app/files/robot/robot.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "sim/solver/layout/body_mass.h"
#include "sim/world/builder/builder.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;

/// +Y up becomes +Z up.
const Matrix3f UPRIGHT{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}};

/// A hinge in the middle of a range about an axis.
RobotTurn turnOf(const std::string& name, const Vector3f& axis, const TurnRange& range)
{
    return {name, UPRIGHT * axis, range};
}

/// Turns about two axes across a ball's own that leave it in its cone, or nearly, and about itself.
std::vector<RobotTurn> turnsOfBall(const ActorJoint& joint)
{
    const Vector3f axis = joint.axis.normalized(), first = axis.unitOrthogonal(), second = axis.cross(first);
    // Where the cone's middle is, seen from the pose at rest.
    const Vector3f middle = joint.limits.cone.isZero() ? axis : joint.limits.cone.normalized();
    const Vector3f away = axis.cross(middle);
    const float angle = std::atan2(away.norm(), axis.dot(middle));
    const Vector3f lean = away.isZero() ? Vector3f(0, 0, 0) : Vector3f(angle * away.normalized());
    const auto range = [&](const Vector3f& about) {
        TurnRange turn;
        if (joint.limits.swing >= HALF_TURN) return turn;
        // The rest pose is within its limits, in a cone that leans as well.
        turn.lowest = std::min(lean.dot(about) - joint.limits.swing, 0.0f);
        turn.highest = std::max(lean.dot(about) + joint.limits.swing, 0.0f);
        return turn;
    };
    return {turnOf(joint.name + "_swing", first, range(first)), turnOf(joint.name + "_sway", second, range(second)),
            turnOf(joint.name + "_twist", axis, joint.limits.twist)};
}

void addJoint(RobotLink& link, const ActorJoint& joint)
{
    link.origin = UPRIGHT * joint.anchor;
    switch (joint.type) {
        case JointType::Stiff: return;
        case JointType::Hinge:
        case JointType::Universal: link.turns = {turnOf(joint.name, joint.axis, joint.limits.bend)}; return;
        case JointType::Ball: break;
    }
    link.turns = turnsOfBall(joint);
    link.isBall = !joint.limits.any();
}

/// The capsule along the particles' longest axis that has their spread across it, and reaches as far along it.
void fitCapsule(RobotLink& link, const std::vector<Vector3f>& places, float diameter)
{
    Vector3f middle = Vector3f::Zero();
    for (const Vector3f& place : places) middle += place / static_cast<float>(places.size());
    Matrix3f spread = Matrix3f::Zero();
    for (const Vector3f& place : places)
        spread += (place - middle) * (place - middle).transpose() / static_cast<float>(places.size());
    const Eigen::SelfAdjointEigenSolver<Matrix3f> axes(spread);
    const Vector3f axis = axes.eigenvectors().col(2);
    // Of a full cylinder the mean square of the distance from its axis is half of the radius squared; each particle
    // stands for a cube.
    const float across = axes.eigenvalues()[0] + axes.eigenvalues()[1] + diameter * diameter / 6.0f;
    float lowest = 0.0f, highest = 0.0f;
    for (const Vector3f& place : places) {
        const float along = axis.dot(place - middle);
        lowest = std::min(lowest, along), highest = std::max(highest, along);
    }
    const float half = 0.5f * (highest - lowest + diameter);
    link.radius = std::min(std::sqrt(2.0f * across), half);
    const Vector3f centre = middle + 0.5f * (highest + lowest) * axis, end = (half - link.radius) * axis;
    link.ends = {UPRIGHT * (centre - end), UPRIGHT * (centre + end)};
}

/// Bodies whose particles are so near each other that simulators with other shapes would have them touch.
bool meetAtRest(const Actor& actor, uint32_t one, uint32_t other)
{
    const auto near = [&](uint32_t p) {
        return std::ranges::any_of(actor.bodies[other].particles,
                                   [&](uint32_t q) { return p == q || touchAtRest(actor, p, q); });
    };
    return neverTouch(actor, one, other) || std::ranges::any_of(actor.bodies[one].particles, near);
}

}  // namespace

Robot robotOf(const Actor& actor, float density)
{
    WorldBuilder builder(0.5f * actor.diameter);
    Material material;
    material.density = density;
    addActor(builder, actor, builder.addMaterial(material), {});
    const World world = builder.build();
    Robot robot{actor.name, {}, {}};
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        const ActorBody& body = actor.bodies[b];
        RobotLink link;
        link.name = body.name;
        link.parent = body.parent;
        const BodyMass mass = bodyMass(world, world.bodies[b]);
        link.mass = static_cast<float>(mass.mass);
        link.centre = link.origin = UPRIGHT * world.bodies[b].restCentre;
        // From sums of r r^T; what cannot turn, as particles in a line, has that of balls about it.
        const Matrix3f moments = mass.moments.cast<float>();
        Matrix3f inertia = moments.trace() * Matrix3f::Identity() - moments;
        inertia += 0.1f * link.mass * actor.diameter * actor.diameter * Matrix3f::Identity();
        link.inertia = UPRIGHT * inertia * UPRIGHT.transpose();
        std::vector<Vector3f> places;
        for (const uint32_t p : body.particles) places.push_back(actor.particles[p]);
        fitCapsule(link, places, actor.diameter);
        for (const ActorJoint& joint : actor.joints)
            if (joint.child == b) addJoint(link, joint);
        robot.links.push_back(std::move(link));
    }
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        for (uint32_t other = b + 1; other < actor.bodies.size(); ++other) {
            const bool areJoined = actor.bodies[b].parent == int32_t(other) || actor.bodies[other].parent == int32_t(b);
            if (!areJoined && meetAtRest(actor, b, other)) robot.apart.push_back({b, other});
        }
    return robot;
}

float hingeInertia(const RobotLink& link)
{
    constexpr float SHARE = 0.01f;  // of the link's own, in the mean of its axes
    return SHARE * link.inertia.trace() / 3.0f;
}

std::string numbersOf(const Vector3f& v)
{
    return fmt::format("{:.6g} {:.6g} {:.6g}", v.x(), v.y(), v.z());
}

}  // namespace knuckle
