#include <algorithm>
#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

TEST(Grains, NothingIsFasterThanTheMaximumSpeed)
{
    Settings settings;
    settings.maxSpeed = 2.0f;
    WorldBuilder builder = makeBuilder(settings);
    Particle grain;
    grain.position = {3, 0, 0};
    builder.addLooseParticle(grain);
    addBox(builder, {3, 3, 3}, {}, {0, 1, 0}, {0, 30, 0});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    for (const Vector3f& v : solver.readParticles().velocities) EXPECT_LE(v.norm(), 2.0f * (1 + 1e-5f));
    // Reached after 2 / g seconds and kept afterwards; a substep of 1/240 s adds gravity's part before the limit
    // applies.
    const double fallen = 2.0 * (1.0 - 2.0 / GRAVITY) + 0.5 * 4.0 / GRAVITY;
    EXPECT_NEAR(solver.readParticles().positions[0].y(), -fallen, GRAVITY / 240.0);
}

TEST(Grains, MassScalingHasTheUpperOfTwoGiveWay)
{
    Settings settings;
    settings.gravity = {0, -1e-4f, 0};  // only to define up
    settings.massScaling = 5.0f;
    WorldBuilder builder = makeBuilder(settings);
    Particle grain;
    builder.addLooseParticle(grain);
    grain.position = {0, 1.5f * DIAMETER, 0};
    grain.velocity = {0, -1, 0};
    builder.addLooseParticle(grain);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.5);
    // Inelastic, with masses 1 and exp(-k d) at the place where they meet.
    const double upper = std::exp(-5.0 * DIAMETER), together = -upper / (1.0 + upper);
    const auto velocities = solver.readParticles().velocities;
    // With these masses they exchange all momentum; they meet slightly nearer or further away, 1 %.
    EXPECT_NEAR(velocities[0].y() + upper * velocities[1].y(), -upper, 0.01 * upper);
    // They do not quite stay together: they part with 3.5 % of their speed of approach.
    for (const Vector3f& v : velocities) EXPECT_NEAR(v.y(), together, 0.03);
}

}  // namespace knuckle::test
