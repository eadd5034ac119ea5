#include "sim/solver/drive/drive_stage.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "sim/solver/pack.h"

namespace knuckle {

namespace {

constexpr const char* JOINTS = "drive";
constexpr const char* PINS = "pin";

const Object& objectOf(const World& world, const Puppet& puppet)
{
    return world.objects[world.animations[puppet.animation].object];
}

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

/// Index into the trees' joints of the one between two bodies, or, without a second one, of a body's own.
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

gpu::GpuJointDrive packDrive(const DriveSpring& spring, const JointSide& side, bool hinge)
{
    gpu::GpuJointDrive drive{};
    const Spring s = spring.isGiven() ? Spring{spring.stiffness, spring.damping} : springOf(spring);
    drive.axis = pack(side.frame * Vector3f::UnitX(), hinge ? 1.0f : 0.0f);
    drive.stiffness = s.stiffness;
    drive.damping = s.damping;
    drive.isGiven = spring.isGiven() ? 1 : 0;
    drive.greatestTorque = bounded(spring.greatestTorque);
    return drive;
}

gpu::GpuPin packPin(const DriveSpring& spring)
{
    gpu::GpuPin pin{};
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
    const auto isOf = [&](uint32_t body) {
        return body >= object.bodyStart && body < object.bodyStart + object.bodyCount;
    };
    return std::ranges::any_of(world.joints, [&](const Joint& joint) {
        return (isOf(joint.parent) && neverResponds(world.bodies[joint.child])) ||
               (isOf(joint.child) && neverResponds(world.bodies[joint.parent]));
    });
}

gpu::GpuPuppet packPuppet(const World& world, const Puppet& puppet, uint32_t firstBody, size_t firstKey)
{
    const Object& object = objectOf(world, puppet);
    gpu::GpuPuppet p{};
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

gpu::vec4 packTurn(const Quaternionf& q)
{
    return pack(q.vec(), q.w());
}

/// What is uploaded, as it grows puppet by puppet.
struct Uploads {
    std::vector<gpu::GpuPuppet> puppets;
    std::vector<gpu::GpuJointDrive> drives;
    std::vector<gpu::GpuPin> pins;
    std::vector<gpu::vec4> keys, driveStates, pinStates;
    std::vector<gpu::uvec2> order;
};

void addOrder(Uploads& out, const World& world, const Puppet& puppet, uint32_t firstBody)
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

void addJoints(Uploads& out, const StageSetup& setup, const Puppet& puppet, uint32_t firstBody,
               const std::vector<uint32_t>& rows)
{
    const World& world = setup.world;
    const Object& object = objectOf(world, puppet);
    for (const Driven& driven : drivenJoints(world, puppet)) {
        const uint32_t body = object.bodyStart + driven.body, parent = object.bodyStart + driven.parent;
        const Joint& joint = *driven.joint;
        gpu::GpuJointDrive drive = packDrive(puppet.joints[driven.body],
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
        for (const gpu::vec4& texel : {gpu::vec4{0, 0, 0, 1}, packTurn(turn), gpu::vec4{0, 0, 0, 1}, none})
            out.driveStates.push_back(texel);
    }
}

void addPins(Uploads& out, const StageSetup& setup, const Puppet& puppet, uint32_t firstBody,
             const std::vector<uint32_t>& rows)
{
    const World& world = setup.world;
    const Object& object = objectOf(world, puppet);
    for (const Pin& wanted : puppet.pins) {
        const Body& body = world.bodies[object.bodyStart + wanted.body];
        gpu::GpuPin pin = packPin(wanted.spring);
        pin.body = firstBody + wanted.body;
        pin.joint = treeJointOf(setup.layout.jointTrees, object.bodyStart + wanted.body);
        pin.row = rows[out.pins.size()];
        out.pins.push_back(pin);
        const gpu::vec4 none{0, 0, 0, 0};
        for (const gpu::vec4& texel :
             {gpu::vec4{0, 0, 0, 1}, packTurn(body.rotation), none, none, pack(body.position, 0), none})
            out.pinStates.push_back(texel);
    }
}

/// When a body of a puppet is limp, before and after it was caught, and when that is.
gpu::uvec4 limpTimes(const Settings& settings, const Puppet& puppet, uint32_t body)
{
    if (!puppet.caught) return {settings.substepAt(puppet.limpTimes[body]), NO_SUBSTEP, NO_SUBSTEP, 0};
    return {settings.substepAt(puppet.limpTimes[body]), settings.substepAt(puppet.caught->limpTimes[body]),
            settings.substepAt(puppet.caught->time), 0};
}

gpu::uvec2 caughtRelease(const StageSetup& setup, const Puppet& puppet, uint32_t body)
{
    const std::vector<uint32_t>& held = setup.layout.heldBodies;
    const auto entry = std::ranges::lower_bound(held, objectOf(setup.world, puppet).bodyStart + body);
    const bool isHeld = entry != held.end() && *entry == objectOf(setup.world, puppet).bodyStart + body;
    if (!puppet.caught || !isHeld) return {NO_INDEX, NO_SUBSTEP};
    return {static_cast<uint32_t>(entry - held.begin()),
            setup.world.settings.substepAt(puppet.caught->releaseTimes[body])};
}

}  // namespace

DriveStage::DriveStage(const StageSetup& setup)
    : parameters_(setup.parameters),
      catches_(std::ranges::any_of(setup.world.puppets, [](const Puppet& p) { return p.caught.has_value(); })),
      hits_(std::ranges::any_of(setup.world.puppets, [](const Puppet& p) { return std::isfinite(p.hit.impulse); }))
{
}

void DriveStage::reserveRows(RowPlan& rows, const World& world, const Layout&)
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

void DriveStage::upload(const StageSetup& setup)
{
    const World& world = setup.world;
    const std::vector<uint32_t> jointRows = setup.rows.rowsOf(JOINTS), pinRows = setup.rows.rowsOf(PINS);
    const std::vector<uint32_t>& first = setup.layout.firstAnimated;
    std::vector<gpu::uvec4> limp(first.back(), gpu::uvec4{NO_SUBSTEP, NO_SUBSTEP, NO_SUBSTEP, 0});
    std::vector<gpu::uvec2> again(first.back(), gpu::uvec2{NO_INDEX, NO_SUBSTEP});
    Uploads out;
    out.order.resize(first.back());
    for (const Puppet& puppet : world.puppets) {
        const uint32_t firstBody = first[puppet.animation], bodies = objectOf(world, puppet).bodyCount;
        out.puppets.push_back(packPuppet(world, puppet, firstBody, out.keys.size()));
        addOrder(out, world, puppet, firstBody);
        for (const StrengthKey& key : puppet.strength)
            out.keys.push_back({key.time, key.value, key.smooth ? 1.0f : 0.0f, 0});
        for (uint32_t b = 0; b < bodies; ++b) {
            limp[firstBody + b] = limpTimes(world.settings, puppet, b);
            again[firstBody + b] = caughtRelease(setup, puppet, b);
        }
        addJoints(out, setup, puppet, firstBody, jointRows);
        addPins(out, setup, puppet, firstBody, pinRows);
    }
    setup.parameters.puppetCount = static_cast<uint32_t>(out.puppets.size());
    setup.parameters.jointDriveCount = static_cast<uint32_t>(out.drives.size());
    setup.parameters.pinCount = static_cast<uint32_t>(out.pins.size());
    puppets = {"puppets", std::span<const gpu::GpuPuppet>(out.puppets)};
    jointDrives = {"jointDrives", std::span<const gpu::GpuJointDrive>(out.drives)};
    pins = {"pins", std::span<const gpu::GpuPin>(out.pins)};
    strengthKeys = {"strengthKeys", std::span<const gpu::vec4>(out.keys)};
    puppetOrder = {"puppetOrder", std::span<const gpu::uvec2>(out.order)};
    limpSubsteps = {"limpSubsteps", std::span<const gpu::uvec4>(limp)};
    caughtReleases = {"caughtReleases", std::span<const gpu::uvec2>(again)};
    driveLevels = {"driveLevels", limp.size()};
    driveHits = {"driveHits", limp.size()};
    catchOffsets = {"catchOffsets", 2 * limp.size()};
    puppetStates = {"puppetStates", 2 * out.puppets.size()};
    composites = {"composites", 3 * limp.size()};
    carried = {"carried", 3 * limp.size()};
    driveInertias = {"driveInertias", 4 * limp.size()};
    driveStates = {"driveStates", std::span<const gpu::vec4>(out.driveStates)};
    pinStates = {"pinStates", std::span<const gpu::vec4>(out.pinStates)};
    pinsGiven = {"pinsGiven", PIN_GIVEN_TEXELS * out.pins.size()};
    driveStiffness = {"driveStiffness", DRIVE_STIFFNESS_TEXELS * setup.layout.jointTrees.joints.size()};
    driveLevels.clear();
    driveHits.clear();
    catchOffsets.clear();
    puppetStates.clear();
    pinsGiven.clear();
    driveStiffness.clear();
}

void DriveStage::addBuffers(BufferTable& table)
{
    table.add(Lifetime::Constant, puppets, jointDrives, pins, strengthKeys, puppetOrder, caughtReleases);
    table.add(Lifetime::Scratch, composites, carried, driveInertias);
    table.add(Lifetime::State, limpSubsteps, driveStates, pinStates, pinsGiven, driveStiffness, driveLevels, driveHits,
              catchOffsets, puppetStates);
}

void DriveStage::measure(Measures& out) const
{
    Vector3f impulse(0, 0, 0);
    const std::vector<gpu::vec4> given = pinsGiven.download();
    for (size_t p = 0; p < given.size(); p += PIN_GIVEN_TEXELS) {
        const gpu::vec4 &force = given[p], &torque = given[p + 1], &sum = given[p + 2];
        out.pinForce = std::max(out.pinForce, Vector3f(force.x, force.y, force.z).norm());
        out.pinTorque = std::max(out.pinTorque, Vector3f(torque.x, torque.y, torque.z).norm());
        impulse += Vector3f(sum.x, sum.y, sum.z);
        out.pinWork += sum.w;
    }
    out.pinImpulse = impulse.norm();
    const std::vector<gpu::uvec4> states = puppetStates.download();
    for (size_t p = 0; p < states.size(); p += 2) {
        out.caughtCount += states[p].x == PUPPET_CAUGHT ? 1 : 0;
        out.knockedOutCount += states[p].z;
    }
}

void DriveStage::catchAgain(Recorder& recorder) const
{
    if (catches_) recorder.perElement(catch_, parameters_.puppetCount);
}

void DriveStage::end(Recorder& recorder) const
{
    if (hits_) recorder.perElement(hit_, parameters_.animatedCount);
}

void DriveStage::begin(Recorder& recorder) const
{
    recorder.perElement(strength_, parameters_.puppetCount);
    recorder.perElement(inertia_, parameters_.puppetCount);
    recorder.perElement(beginJoints_, parameters_.jointDriveCount);
    recorder.perElement(beginPins_, parameters_.pinCount);
}

void DriveStage::pull(Recorder& recorder) const
{
    recorder.perElement(pullJoints_, parameters_.jointDriveCount);
    recorder.perElement(pullPins_, parameters_.pinCount);
}

}  // namespace knuckle
