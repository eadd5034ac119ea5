#include "sim/solver/drive/drive_upload.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr const char* JOINTS = "drive";
constexpr const char* PINS = "pin";

const Joint* jointBetween(const World& world, uint32_t a, uint32_t b)
{
    const auto found = std::ranges::find_if(world.joints, [&](const Joint& joint) { return joint.connects(a, b); });
    return found == world.joints.end() ? nullptr : &*found;
}

/// A joint of a puppet that is driven.
struct Driven {
    uint32_t body = 0, parent = 0;  ///< Within the object.
    const Joint* joint = nullptr;
};

std::vector<Driven> drivenJoints(const World& world, const Puppet& puppet)
{
    std::vector<Driven> driven;
    const Object& object = objectOf(world, puppet);
    const std::vector<AnimatedLink> links = linksOf(world, world.animations[puppet.animation]);
    for (uint32_t b = 0; b < links.size(); ++b) {
        if (links[b].parent == NO_INDEX || !puppet.joints[b].acts()) continue;
        const Joint* joint = jointBetween(world, object.bodyStart + b, object.bodyStart + links[b].parent);
        if (joint != nullptr && joint->type != JointType::Stiff) driven.push_back({b, links[b].parent, joint});
    }
    return driven;
}

/// Index into the trees' joints of the joint between two bodies, or, if only one is given, of its own.
uint32_t treeJointOf(const JointTrees& trees, uint32_t a, uint32_t b = NO_INDEX)
{
    const auto found = std::ranges::find_if(trees.joints, [&](const JointTrees::Joint& joint) {
        return b == NO_INDEX ? joint.body == a : std::minmax(joint.body, joint.parent) == std::minmax(a, b);
    });
    return static_cast<uint32_t>(found - trees.joints.begin());
}

struct Spring {
    float stiffness = 0.0f, damping = 0.0f;  ///< Times an inertia [1/s2], [1/s].
};

Spring springOf(const DriveSpring& s)
{
    const float rate = 2.0f * std::numbers::pi_v<float> * s.frequency;
    return {rate * rate, 2.0f * s.dampingRatio * rate};
}

float bounded(float greatest)
{
    return std::min(greatest, std::numeric_limits<float>::max());
}

gpu::JointDrive packDrive(const DriveSpring& spring, const JointSide& side, bool hinge)
{
    gpu::JointDrive drive{};
    const Spring s = spring.isGiven() ? Spring{spring.stiffness, spring.damping} : springOf(spring);
    drive.axis = pack(side.frame * Vector3f::UnitX(), hinge ? 1.0f : 0.0f);
    drive.stiffness = s.stiffness;
    drive.damping = s.damping;
    drive.isGiven = spring.isGiven() ? 1 : 0;
    drive.greatestTorque = bounded(spring.greatestTorque);
    return drive;
}

gpu::Pin packPin(const DriveSpring& spring)
{
    gpu::Pin pin{};
    const Spring s = springOf(spring);
    pin.stiffness = s.stiffness;
    pin.damping = s.damping;
    pin.greatestForce = bounded(spring.greatestForce);
    pin.greatestTorque = bounded(spring.greatestTorque);
    return pin;
}

/// Whether something fixed for ever holds a body of an object.
bool isHeld(const World& world, const Object& object)
{
    return std::ranges::any_of(world.joints, [&](const Joint& joint) {
        return (object.has(joint.parent) && neverResponds(world.bodies[joint.child])) ||
               (object.has(joint.child) && neverResponds(world.bodies[joint.parent]));
    });
}

gpu::Puppet packPuppet(const World& world, const Puppet& puppet, uint32_t firstBody, size_t firstKey)
{
    const Object& object = objectOf(world, puppet);
    gpu::Puppet p{};
    p.firstBody = firstBody;
    p.bodyCount = object.bodyCount;
    p.firstKey = static_cast<uint32_t>(firstKey);
    p.keyCount = static_cast<uint32_t>(puppet.strength.size());
    p.isHeld = isHeld(world, object) ? 1 : 0;
    for (uint32_t b = 0; b < object.bodyCount; ++b) p.mass += world.bodies[object.bodyStart + b].mass;
    p.hitImpulse = bounded(puppet.hit.impulse);
    p.hitFalloff = puppet.hit.falloff;
    p.hitHold = puppet.hit.hold;
    p.hitRecover = puppet.hit.recover;
    p.knockDistance = bounded(puppet.knockOut.distance);
    p.knockTime = bounded(puppet.knockOut.torqueTime);
    p.catchSubstep = NO_SUBSTEP;
    if (!puppet.caught) return p;
    p.catchSubstep = world.settings.substepAt(puppet.caught->time);
    p.catchHere = puppet.caught->here ? 1 : 0;
    p.catchOtherwise = static_cast<uint32_t>(puppet.caught->otherwise);
    p.catchBlend = puppet.caught->blend;
    p.catchNear = puppet.caught->near;
    p.catchWithin = puppet.caught->within;
    return p;
}

void addOrder(DriveUpload& out, const World& world, const Puppet& puppet, uint32_t firstBody)
{
    const std::vector<AnimatedLink> links = linksOf(world, world.animations[puppet.animation]);
    const auto depth = [&](uint32_t body) {
        uint32_t above = 0;
        for (; links[body].parent != NO_INDEX; body = links[body].parent) ++above;
        return above;
    };
    std::vector<uint32_t> order(links.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::stable_sort(order, {}, depth);
    for (size_t i = 0; i < order.size(); ++i) {
        const bool pinned = std::ranges::find(puppet.pins, order[i], &Pin::body) != puppet.pins.end();
        out.order[firstBody + i] = {firstBody + order[i], pinned ? 1u : 0u};
    }
}

void addJoints(DriveUpload& out, const StageSetup& setup, const Puppet& puppet, uint32_t firstBody,
               const std::vector<uint32_t>& rows)
{
    const World& world = setup.world;
    const Object& object = objectOf(world, puppet);
    for (const Driven& driven : drivenJoints(world, puppet)) {
        const uint32_t body = object.bodyStart + driven.body, parent = object.bodyStart + driven.parent;
        const Joint& joint = *driven.joint;
        gpu::JointDrive drive = packDrive(puppet.joints[driven.body],
                                          joint.child == body ? joint.childSide : joint.parentSide,
                                          joint.type == JointType::Hinge);
        drive.body = firstBody + driven.body;
        drive.joint = treeJointOf(setup.layout.jointTrees, body, parent);
        drive.row = rows[2 * out.drives.size()];
        drive.parentRow = rows[2 * out.drives.size() + 1];
        drive.puppet = static_cast<uint32_t>(out.puppets.size()) - 1;
        out.drives.push_back(drive);
        const Quaternionf turn = world.bodies[parent].rotation.conjugate() * world.bodies[body].rotation;
        const gpu::vec4 none{0, 0, 0, 0};
        for (const gpu::vec4& texel : {gpu::vec4{0, 0, 0, 1}, pack(turn), gpu::vec4{0, 0, 0, 1}, none})
            out.driveStates.push_back(texel);
    }
}

void addPins(DriveUpload& out, const StageSetup& setup, const Puppet& puppet, uint32_t firstBody,
             const std::vector<uint32_t>& rows)
{
    const World& world = setup.world;
    const Object& object = objectOf(world, puppet);
    for (const Pin& wanted : puppet.pins) {
        const Body& body = world.bodies[object.bodyStart + wanted.body];
        gpu::Pin pin = packPin(wanted.spring);
        pin.body = firstBody + wanted.body;
        pin.joint = treeJointOf(setup.layout.jointTrees, object.bodyStart + wanted.body);
        pin.row = rows[out.pins.size()];
        out.pins.push_back(pin);
        const gpu::vec4 none{0, 0, 0, 0};
        for (const gpu::vec4& texel :
             {gpu::vec4{0, 0, 0, 1}, pack(body.rotation), none, none, pack(body.position, 0), none})
            out.pinStates.push_back(texel);
    }
}

/// When a body of a puppet goes limp, before and after it was caught, and when it is caught.
gpu::uvec4 limpTimes(const Settings& settings, const Puppet& puppet, uint32_t body)
{
    if (!puppet.caught) return {settings.substepAt(puppet.limpTimes[body]), NO_SUBSTEP, NO_SUBSTEP, 0};
    return {settings.substepAt(puppet.limpTimes[body]), settings.substepAt(puppet.caught->limpTimes[body]),
            settings.substepAt(puppet.caught->time), 0};
}

gpu::uvec2 caughtRelease(const StageSetup& setup, const Puppet& puppet, uint32_t body)
{
    const uint32_t entry = setup.layout.heldIndex(objectOf(setup.world, puppet).bodyStart + body);
    if (!puppet.caught || entry == NO_INDEX) return {NO_INDEX, NO_SUBSTEP};
    return {entry, setup.world.settings.substepAt(puppet.caught->releaseTimes[body])};
}

}  // namespace

void reserveDriveRows(RowPlan& rows, const World& world)
{
    for (const Puppet& puppet : world.puppets) {
        const uint32_t first = objectOf(world, puppet).bodyStart;
        for (const Driven& driven : drivenJoints(world, puppet)) {
            rows.reserveAngular(JOINTS, first + driven.body);
            rows.reserveAngular(JOINTS, first + driven.parent);
        }
        for (const Pin& pin : puppet.pins) rows.reserveAngular(PINS, first + pin.body);
    }
}

DriveUpload driveUpload(const StageSetup& setup)
{
    const World& world = setup.world;
    const std::vector<uint32_t> jointRows = setup.rows.rowsOf(JOINTS), pinRows = setup.rows.rowsOf(PINS);
    const std::vector<uint32_t>& first = setup.layout.firstAnimated;
    DriveUpload out;
    out.limp.assign(first.back(), {NO_SUBSTEP, NO_SUBSTEP, NO_SUBSTEP, 0});
    out.again.assign(first.back(), {NO_INDEX, NO_SUBSTEP});
    out.order.resize(first.back());
    for (const Puppet& puppet : world.puppets) {
        const uint32_t firstBody = first[puppet.animation], bodies = objectOf(world, puppet).bodyCount;
        out.puppets.push_back(packPuppet(world, puppet, firstBody, out.keys.size()));
        addOrder(out, world, puppet, firstBody);
        for (const StrengthKey& key : puppet.strength)
            out.keys.push_back({key.time, key.value, key.smooth ? 1.0f : 0.0f, 0});
        for (uint32_t b = 0; b < bodies; ++b) {
            out.limp[firstBody + b] = limpTimes(world.settings, puppet, b);
            out.again[firstBody + b] = caughtRelease(setup, puppet, b);
        }
        addJoints(out, setup, puppet, firstBody, jointRows);
        addPins(out, setup, puppet, firstBody, pinRows);
    }
    return out;
}

}  // namespace knuckle
