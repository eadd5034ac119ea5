#include <functional>

#include "sim/world/builder/parts/cloth.h"
#include "sim/world/builder/parts/rope.h"
#include "tests/solver/determinism_worlds.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

World softWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    Material jelly;
    jelly.elasticity.creep = 20.0f;
    builder.addMaterial(jelly);
    builder.addCollider({});
    for (int k = 0; k < 7; ++k) {
        const Vector3f place(0.04f * static_cast<float>(k), 0.2f + 0.45f * static_cast<float>(k), 0);
        builder.beginObject("box");
        if (k % 3 == 2) builder.addBody("rigid", boxLattice({4, 3, 4}, DIAMETER), 0);
        else builder.addSoftBody("soft", boxLattice({4, 4, 5}, DIAMETER), 0);
        builder.endObject({place}, {0, -3, 0}, {1, 0, 2});
    }
    return builder.build();
}

World ropeWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    ClothSpec spec;
    spec.tearForce = 2000.0f;
    spec.bendCompliance = 0.01f;
    const ClothSheet sheet = gridSheet(1.2f, 1.0f, DIAMETER, spec);
    const std::vector<uint32_t> held = {0, sheet.columns - 1, sheet.columns * (sheet.rows - 1)};
    builder.addCollider({});
    addCloth(builder, "cloth", sheet, spec, held, {}, {Vector3f(0, 1, 0)});
    RopeSpec rope;
    for (int k = 0; k < 4; ++k) {
        builder.beginObject("box");
        const uint32_t body = builder.addBody("box", boxLattice({3, 4, 3}, DIAMETER), 0);
        builder.endObject({Vector3f(0.1f * static_cast<float>(k), 1.4f + 0.5f * static_cast<float>(k), 0)}, {0, -3, 0});
        rope.end = {RopeEnd::Kind::Attached, builder.ownParticles(body)[0]};
    }
    rope.from = {-0.5f, 4.0f, 0};
    rope.start.kind = RopeEnd::Kind::Fixed;
    addRope(builder, "rope", rope);
    return builder.build();
}

World fluidWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    Material heavy;
    heavy.density = 4000.0f;
    builder.addMaterial(heavy);
    for (const Vector3f& normal : {Vector3f(0, 1, 0), Vector3f(1, 0, 0), Vector3f(0, 0, 1), Vector3f(-1, 0, -1)})
        builder.addCollider(planeAt(-0.4f * normal, normal));
    Material fluid;
    fluid.fluid = true;
    for (int kind = 0; kind < 2; ++kind) {
        fluid.density = kind == 0 ? 1000.0f : 700.0f;
        const uint32_t material = builder.addMaterial(fluid);
        std::vector<Vector3f> places = boxLattice({11, 5, 13}, builder.fluidSpacing());
        for (Vector3f& place : places) place.y() += 0.3f * static_cast<float>(kind) - 0.2f;
        builder.addFluid(places, {0.5f, -1, 0}, material);
    }
    // One lies on the ground from the start.
    for (int k = 0; k < 4; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 2, 3}, DIAMETER), 0);
        const float height = k == 3 ? -0.301f : 0.5f + 0.3f * static_cast<float>(k);
        builder.endObject({Vector3f(0.05f * static_cast<float>(k), height, 0)}, {0, k == 3 ? 0.0f : -3.0f, 0});
    }
    return builder.build();
}

World emitterWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    Material fluid;
    fluid.fluid = true;
    const uint32_t water = builder.addMaterial(fluid);
    builder.addCollider({});
    for (int k = 0; k < 2; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 2, 3}, DIAMETER), 0);
        builder.endObject({Vector3f(0.05f * static_cast<float>(k), 0.2f + 0.25f * static_cast<float>(k), 0)});
    }
    std::vector<Vector3f> places = boxLattice({8, 6, 9}, builder.fluidSpacing());
    for (Vector3f& place : places) place += Vector3f(0.6f, 0.2f, 0);
    builder.addFluid(places, {0, 0, 0}, water);
    Emitter emitter;
    emitter.material = water;
    emitter.pool = 700;
    for (const float side : {-1.0f, 1.0f}) {
        emitter.velocity = {-3.0f * side, 0.5f, 0.1f};
        emitter.nozzle = placed(discNozzle(0.11f, builder.fluidSpacing()), {0.8f * side, 0.9f, 0},
                                emitter.velocity.normalized());
        emitter.takesOldest = side > 0.0f;
        builder.addEmitter(emitter);
    }
    Collider drain;
    drain.shape = ColliderShape::Sphere;
    drain.position = {0.6f, 0, 0};
    drain.radius = 0.35f;
    builder.addDrain(drain);
    return builder.build();
}

World windyWorld()
{
    WorldBuilder builder(DIAMETER / 2);
    builder.addMaterial({});
    Material wet;
    wet.fluid = true;
    const uint32_t water = builder.addMaterial(wet);
    builder.addCollider({});
    builder.setWind({.velocity = {6, 0, 2}, .density = 20, .gusts = 0.6f, .gustSize = 0.8f});
    ForceField blast{.kind = FieldKind::Push, .falloff = FieldFalloff::Linear, .region = {}, .strength = 90};
    blast.region.shape = ColliderShape::Sphere;
    blast.region.radius = 1.5f;
    blast.start = 0.2f;
    blast.stop = 0.25f;
    builder.addForceField(blast);
    blast.kind = FieldKind::Swirl;
    builder.addForceField(blast);
    ClothSpec spec;
    const ClothSheet sheet = gridSheet(0.9f, 0.8f, DIAMETER, spec);
    addCloth(builder, "cloth", sheet, spec, std::vector<uint32_t>{0, sheet.columns - 1}, {}, {Vector3f(0, 1, 0)});
    for (int k = 0; k < 5; ++k) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 4, 2}, DIAMETER), 0);
        builder.endObject({Vector3f(0.1f * static_cast<float>(k), 0.25f + 0.45f * static_cast<float>(k), 0.1f)});
    }
    std::vector<Vector3f> places = boxLattice({7, 6, 5}, builder.fluidSpacing());
    for (Vector3f& place : places) place += Vector3f(-0.6f, 0.3f, 0.2f);
    builder.addFluid(places, {0, 0, 0}, water);
    return builder.build();
}

WorldBuilder sleepyBuilder()
{
    Settings settings;
    settings.sleepSpeed = 0.02f;
    WorldBuilder builder(DIAMETER / 2, settings);
    builder.addMaterial({});
    builder.addCollider({});
    return builder;
}

namespace {

/// Opens an object of joined cubes in a row along x. @param typeOf the joint after a cube. @returns the bodies.
std::vector<uint32_t> beginRow(WorldBuilder& builder, int count, const std::function<JointType(int)>& typeOf)
{
    builder.beginObject("row");
    std::vector<uint32_t> bodies;
    for (int b = 0; b < count; ++b) {
        std::vector<Vector3f> places = boxLattice({3, 3, 3}, DIAMETER);
        for (Vector3f& p : places) p.x() += 4 * DIAMETER * static_cast<float>(b);
        bodies.push_back(builder.addBody("body", places, 0));
    }
    for (int b = 0; b + 1 < count; ++b) {
        JointSpec spec;
        spec.type = typeOf(b);
        spec.anchor.x() = 4 * DIAMETER * (static_cast<float>(b) + 0.5f);
        builder.addJoint(bodies[b], bodies[b + 1], spec);
    }
    return bodies;
}

}  // namespace

World heldWorld()
{
    WorldBuilder builder = sleepyBuilder();
    for (int k = 0; k < 4; ++k) {
        const std::vector<uint32_t> bodies = beginRow(builder, 4,
                                                      [&](int b) { return static_cast<JointType>((k + b) % 4); });
        // Holds one end, the other, both, all.
        if (k != 1) builder.holdBody(bodies[0], 0.2f);
        if (k != 0) builder.holdBody(bodies[3], 0.2f + 0.1f * static_cast<float>(k % 2));
        for (const uint32_t body : bodies)
            if (k == 3) builder.holdBody(body, 0.3f);
        builder.endObject({Vector3f(0, 0.6f, 0.5f * static_cast<float>(k))});
    }
    return builder.build();
}

namespace {

/// Driven, too weakly for its clips, with pins at both ends, and let go in its middle.
Puppet puppetOf(uint32_t animation)
{
    Puppet puppet;
    puppet.animation = animation;
    puppet.joints.assign(3, {.frequency = 6.0f, .dampingRatio = 0.7f, .greatestTorque = 3.0f});
    puppet.limpTimes = {DriveSpring::INFINITE, 0.5f, DriveSpring::INFINITE};
    puppet.pins = {{0, {.frequency = 3.0f}}, {2, {.frequency = 2.0f, .greatestForce = 50.0f}}};
    puppet.hit.impulse = 5.0f;
    puppet.knockOut = {0.6f, 0.5f};
    if (animation == 3) puppet.caught = Catch{.time = 0.6f, .blend = 0.2f, .near = 0.3f};
    if (puppet.caught) puppet.caught->releaseTimes = puppet.caught->limpTimes = {1.2f, 1.3f, DriveSpring::INFINITE};
    puppet.strength = {{0.0f, 1.0f, true}, {0.3f, 0.4f, false}, {0.6f, 2.0f, false}};
    return puppet;
}

World dancers(bool driven)
{
    WorldBuilder builder = sleepyBuilder();
    std::vector<uint32_t> clips;
    for (const float pace : {7.0f, 4.0f}) {
        BodyClip clip{"swing", 30, 3};
        for (float t = 0; t < 0.71f; t += 1 / clip.rate) {
            clip.roots.emplace_back(0.2f * std::sin(pace * t), 0, 0.1f * t);
            for (const float body : {0.0f, 1.0f, 2.0f})
                clip.turns.emplace_back(
                    Eigen::AngleAxisf(0.5f * std::sin(pace * t + body) + 0.3f * t, Vector3f(body, 1, 0).normalized()));
        }
        clips.push_back(builder.addClip(std::move(clip)));
    }
    std::vector<std::vector<uint32_t>> rows;
    for (uint32_t k = 0; k < 4; ++k) {
        const std::vector<uint32_t> bodies = beginRow(builder, 3, [](int) { return JointType::Ball; });
        rows.push_back(bodies);
        const Pose pose{Vector3f(0, 0.2f, 0.6f * static_cast<float>(k))};
        builder.endObject(pose);
        builder.animate(
            {k, pose, {0, 0, 0}, {{.clip = clips[k % 2]}, {.clip = clips[1 - k % 2], .at = 0.2f, .fade = 0.2f}}});
        // One from its middle on, one completely.
        for (uint32_t b = k == 1 ? 1 : 0; b < 3 && k % 2 == 1; ++b) builder.releaseBody(bodies[b], 0.3f);
        if (driven) builder.drive(puppetOf(k));
    }
    const uint32_t firstOfBoxes = builder.particleCount();
    for (const float z : {0.3f, 0.9f, 1.5f}) {
        builder.beginObject("box");
        builder.addBody("box", boxLattice({3, 3, 3}, DIAMETER), 0);
        builder.endObject({Vector3f(0.4f, 0.15f, z)});
    }
    Release touch, region, impulse;
    touch.cause = ReleaseCause::Touch;
    touch.bodies = rows[0];
    touch.firstParticle = firstOfBoxes;
    touch.endParticle = builder.particleCount();
    region.cause = ReleaseCause::Region;
    region.bodies = {rows[2][2]};
    region.region.position = {0.8f, 0.2f, 0.9f};
    region.region.halfExtents = {1, 1, 0.1f};
    region.region.shape = ColliderShape::Box;
    impulse.bodies = rows[1];
    impulse.impulse = 0.5f;
    for (const Release& release : {touch, region, impulse}) builder.addRelease(release);
    return builder.build();
}

}  // namespace

World animatedWorld()
{
    return dancers(false);
}

World drivenWorld()
{
    return dancers(true);
}

}  // namespace knuckle::test
