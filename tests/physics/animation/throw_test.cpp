#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

constexpr double TIME = 0.5;  ///< When the box is thrown: a whole number of steps of 1/60 s [s].
const Vector3f START(0, 5, 0), VELOCITY(3, 4, -1), SPIN(0, 10, 0);

Settings second()
{
    Settings settings;
    settings.velocityOrder = VelocityOrder::Second;
    return settings;
}

/// A box, turned, that is thrown. @param appears whether it is not there before.
uint32_t addThrown(WorldBuilder& builder, bool appears)
{
    const uint32_t box = addBox(builder, {3, 3, 3}, {START, Quaternionf(Eigen::AngleAxisf(1.0f, Vector3f::UnitX()))});
    builder.holdBody(box, static_cast<float>(TIME));
    builder.throwBody(box, VELOCITY, SPIN, appears);
    return box;
}

}  // namespace

TEST(Throw, ABoxFliesOnItsParabola)
{
    for (const bool appears : {false, true}) {
        WorldBuilder builder = makeBuilder(second());
        addThrown(builder, appears);
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, TIME + 1.0);
        const BodyState box = solver.readBodies()[0];
        // The first substep, of 1/480 s, is of first order: it falls h^2 g/2 further, and keeps h g/2 more, which is
        // 0.0102 m after a second; the way along x and z has no such error.
        EXPECT_NEAR(box.position.x(), 3.0, 1e-4) << appears;
        EXPECT_NEAR(box.position.y(), 5.0 + 4.0 - 0.5 * GRAVITY, 0.012) << appears;
        EXPECT_NEAR(box.position.z(), -1.0, 1e-4) << appears;
        EXPECT_NEAR(box.velocity.y(), 4.0 - GRAVITY, 0.012) << appears;
        // As in FreeMotion.ACubeKeepsItsSpin.
        EXPECT_NEAR(box.angularVelocity.y(), 10.0, 0.1) << appears;
        EXPECT_LT(Vector3f(box.angularVelocity.x(), 0, box.angularVelocity.z()).norm(), 0.01f) << appears;
        for (const bool inactive : solver.readParticles().inactive) EXPECT_FALSE(inactive) << appears;
    }
}

TEST(Throw, NothingMeetsABoxThatIsNotThereYet)
{
    for (const bool appears : {false, true}) {
        WorldBuilder builder = makeBuilder(second());
        addThrown(builder, appears);
        // Falls through where the other one waits within its 0.5 s.
        addBox(builder, {3, 3, 3}, {START + Vector3f(0, 0.8f, 0)});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, TIME - world.settings.timeStep);
        const ParticleState state = solver.readParticles();
        for (size_t i = 0; i < world.particles.size(); ++i)
            EXPECT_EQ(state.inactive[i], appears && world.particles[i].body == 0) << i;
        const double time = TIME - world.settings.timeStep;
        const float y = solver.readBodies()[1].position.y();
        if (appears) {
            EXPECT_NEAR(y, 5.8 - 0.5 * GRAVITY * time * time, 0.01);
        } else {
            EXPECT_GT(y, 5.25f);
        }
    }
}

TEST(Throw, ManyWaitApartFromEachOther)
{
    WorldBuilder builder = makeBuilder(second());
    for (int k = 0; k < 4; ++k) {
        const uint32_t box = addBox(builder, {2, 2, 2}, {START});
        builder.holdBody(box, static_cast<float>(0.5 + 0.25 * k));
        builder.throwBody(box, {4, 0, 0}, {0, 0, 0}, true);
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.5);
    // All go the same way, one after the other.
    for (int k = 0; k < 4; ++k) {
        const double time = 1.0 - 0.25 * k;
        const Vector3f place = solver.readBodies()[static_cast<size_t>(k)].position;
        EXPECT_NEAR(place.x(), 4.0 * time, 1e-4) << k;
        EXPECT_NEAR(place.y(), 5.0 - 0.5 * GRAVITY * time * time, 0.012) << k;
    }
}

}  // namespace knuckle::test
