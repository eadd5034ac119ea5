#include <limits>
#include <tuple>
#include <utility>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr float SPEED = 2.0f;  ///< Of the striking cube [m/s].
constexpr float MASS = 27.0f;  ///< Of a cube of 3 x 3 x 3 particles [kg].

Release byImpulse(std::vector<uint32_t> bodies, float impulse)
{
    Release release;
    release.bodies = std::move(bodies);
    release.impulse = impulse;
    return release;
}

/// @param touched first particle and end of those that trigger it.
Release byTouch(std::vector<uint32_t> bodies, std::pair<uint32_t, uint32_t> touched)
{
    Release release;
    release.cause = ReleaseCause::Touch;
    release.bodies = std::move(bodies);
    std::tie(release.firstParticle, release.endParticle) = touched;
    return release;
}

Release byRegion(std::vector<uint32_t> bodies, const Vector3f& centre, float radius)
{
    Release release;
    release.cause = ReleaseCause::Region;
    release.bodies = std::move(bodies);
    release.region.shape = ColliderShape::Sphere;
    release.region.position = centre;
    release.region.radius = radius;
    return release;
}

/// A cube that moves along x at a speed, or is held.
uint32_t addMoved(WorldBuilder& builder, const Vector3f& place, float speed)
{
    const uint32_t body = addBox(builder, {3, 3, 3}, {place});
    const uint32_t clip = builder.addClip({"straight",
                                           0.1f,
                                           1,
                                           {Vector3f::Zero(), Vector3f(10 * speed, 0, 0)},
                                           {Quaternionf::Identity(), Quaternionf::Identity()}});
    builder.animate({builder.world().bodies[body].object, {place}, {0, 0, 0}, {{.clip = clip, .loop = false}}});
    return body;
}

/// A cube as an object of its own. @returns its particles.
std::pair<uint32_t, uint32_t> addCube(WorldBuilder& builder, const Vector3f& place, bool held)
{
    const uint32_t first = builder.particleCount(), body = addBox(builder, {3, 3, 3}, {place});
    if (held) builder.holdBody(body);
    return {first, builder.particleCount()};
}

/// The start of a substep [s].
double timeOf(const World& world, const LetGo& gone)
{
    return gone.substep * double{world.settings.timeStep} / world.settings.substeps;
}

/// Bodies let go within a time [s].
std::vector<LetGo> simulate(const World& world, double seconds)
{
    Solver solver(gpu(), world);
    solver.noteReleases();
    run(solver, world, seconds);
    return solver.letGo();
}

}  // namespace

/// A cube at speed v gives a held one m v (1 + e), and no more.
TEST(ReleaseEvent, AnImpulseIsWhatABlowBrings)
{
    for (const float e : {0.0f, 0.8f})
        for (const float start : {0.3f, 0.311f, 0.325f})  // so that blows fall into different parts of a step
            for (const float part : {0.97f, 1.03f}) {
                WorldBuilder builder = makeBuilder(weightless());
                Material bouncing = builder.material(0);
                bouncing.restitution = e;
                const uint32_t material = builder.addMaterial(bouncing);
                const uint32_t held = addBox(builder, {3, 3, 3});
                builder.holdBody(held);
                builder.beginObject("block");
                builder.addBody("block", boxLattice({3, 3, 3}, DIAMETER), material);
                builder.endObject({{start + 3 * DIAMETER, 0, 0}}, {-SPEED, 0, 0});
                builder.addRelease(byImpulse({held}, part * MASS * SPEED * (1 + e)));
                const World world = builder.build();
                const std::vector<LetGo> gone = simulate(world, 0.5);
                EXPECT_EQ(gone.size(), part < 1 ? 1u : 0u) << "e " << e << " part " << part << " start " << start;
            }
}

/// A cube on a held one gives it m g t in a step of t.
TEST(ReleaseEvent, ALoadGivesItsWeightInEachStep)
{
    for (const float part : {0.9f, 1.1f}) {
        WorldBuilder builder = makeBuilder();
        const uint32_t held = addBox(builder, {3, 3, 3});
        builder.holdBody(held);
        addBox(builder, {3, 3, 3}, {{0, 3 * DIAMETER, 0}});
        const float step = builder.world().settings.timeStep;
        builder.addRelease(byImpulse({held}, part * MASS * static_cast<float>(GRAVITY) * step));
        EXPECT_EQ(simulate(builder.build(), 0.5).size(), part < 1 ? 1u : 0u) << part;
    }
}

/// A moving body meets one that is free, or held, as it does not respond either; other bodies that it touches do not
/// let go of it.
TEST(ReleaseEvent, ATouchIsOfWhatIsNamed)
{
    constexpr float GAP = 0.5f;
    for (const bool held : {false, true}) {
        WorldBuilder builder = makeBuilder(weightless());
        const uint32_t moved = addMoved(builder, {0, 0, 0}, 1.0f);
        addCube(builder, {0, 2.95f * DIAMETER, 0}, true);
        const auto wall = addCube(builder, {3 * DIAMETER + GAP, -0.05f, 0.02f}, held);
        addCube(builder, {0, -2.95f * DIAMETER, 0}, true);
        builder.addRelease(byTouch({moved}, wall));
        const World world = builder.build();
        const std::vector<LetGo> gone = simulate(world, 1.0);
        ASSERT_EQ(gone.size(), 1u) << held;
        EXPECT_EQ(gone[0].body, moved);
        // One diameter between the centres of two balls at a lateral distance of 0.05 and 0.02 m is 0.084 m along x.
        EXPECT_NEAR(timeOf(world, gone[0]), GAP + 0.008f, 0.013f) << held;
    }
}

TEST(ReleaseEvent, ARegionIsReachedByTheFirstParticle)
{
    WorldBuilder builder = makeBuilder(weightless());
    const uint32_t moved = addMoved(builder, {0, 0, 0}, 1.0f), other = addMoved(builder, {0, 1, 0}, -1.0f);
    builder.addRelease(byRegion({moved}, {1, 0, 0}, 0.25f));
    builder.addRelease(byRegion({other}, {1, 1, 0}, 0.25f));
    const World world = builder.build();
    const std::vector<LetGo> gone = simulate(world, 1.0);
    ASSERT_EQ(gone.size(), 1u);
    EXPECT_EQ(gone[0].body, moved);
    const double substep = double{world.settings.timeStep} / world.settings.substeps;
    EXPECT_NEAR(timeOf(world, gone[0]), 1 - 0.25 - DIAMETER, 1.1 * substep);
}

/// Half of a chain is in a region from the start; a ball and a time would let go of it later. The other half stays.
TEST(ReleaseEvent, WhicheverIsFirstCounts)
{
    WorldBuilder builder = makeBuilder();
    beginRow(builder, 4, JointType::Ball);
    builder.endObject({{0, 3, 0}});
    for (const uint32_t b : {0u, 1u, 2u, 3u})
        builder.holdBody(b, b == 3 ? 0.5f : std::numeric_limits<float>::infinity());
    const auto ball = addCube(builder, {builder.world().particles.back().position.x(), 3.6f, 0}, false);
    builder.addRelease(byTouch({2, 3}, ball));
    builder.addRelease(byRegion({2, 3}, {0, 3, 0}, 100.0f));
    const World world = builder.build();
    Solver solver(gpu(), world);
    solver.noteReleases();
    run(solver, world, 1.0);
    const std::vector<LetGo> gone = solver.letGo();
    ASSERT_EQ(gone.size(), 2u);
    for (const LetGo& one : gone) {
        EXPECT_GE(one.body, 2u);
        EXPECT_EQ(one.substep, 1u) << "it is in the region from the start";
    }
    const std::vector<BodyState> bodies = solver.readBodies();
    for (const uint32_t b : {0u, 1u}) EXPECT_EQ(bodies[b].position, world.bodies[b].position);
    for (const uint32_t b : {2u, 3u}) EXPECT_LT(bodies[b].position.y(), world.bodies[b].position.y() - 0.1f);
    EXPECT_LT(solver.measure().worstJointGap, 0.01f * DIAMETER);
}

/// Apart from the blow that lets it go, nothing changes a body's motion.
TEST(ReleaseEvent, WhatTouchesAndIsLetGoMovesOnButForTheBlow)
{
    WorldBuilder builder = makeBuilder();
    const uint32_t moved = addMoved(builder, {0, 0, 0}, 1.0f);
    const auto wall = addCube(builder, {5 * DIAMETER, 0.02f, 0.03f}, false);
    builder.addRelease(byTouch({moved}, wall));
    const World world = builder.build();
    const std::vector<LetGo> gone = simulate(world, 0.5);
    ASSERT_EQ(gone.size(), 1u);
    EXPECT_NEAR(gone[0].velocity.x(), 1.0f, 1e-4f);
    EXPECT_LT(gone[0].change.norm(), 1e-4f);
    EXPECT_EQ(gone[0].changeByJoints.norm(), 0.0f);
}

}  // namespace knuckle::test
