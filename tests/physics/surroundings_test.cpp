#include "tests/physics/fluid/tank.h"

namespace knuckle::test {

namespace {

/// A falling cube, one of rubber and loose particles in gusts.
World windyWorld(const Surroundings& surroundings)
{
    Settings settings;
    settings.substeps = 4;
    settings.gravity = surroundings.gravity;
    settings.linearDamping = surroundings.linearDamping;
    settings.maxSpeed = surroundings.maxSpeed;
    WorldBuilder builder = makeBuilder(settings);
    builder.setWind({.velocity = surroundings.wind, .gusts = 0.5f});
    Material rubber;
    rubber.name = "rubber";
    rubber.restitution = 0.8f;
    builder.addMaterial(rubber);
    builder.addCollider(floorPlane());
    addBox(builder, {3, 3, 3}, {Vector3f(0, 0.5f, 0)});
    builder.beginObject("rubber");
    builder.addBody("rubber", boxLattice({2, 2, 2}, DIAMETER), 1);
    // So near to the floor that it bounces with less gravity alone.
    builder.endObject({Vector3f(1, DIAMETER + 0.005f, 0)});
    for (int k = 0; k < 5; ++k) {
        Particle particle;
        particle.position = {-1, 0.3f * static_cast<float>(k + 1), 0};
        builder.addLooseParticle(particle);
    }
    return builder.build();
}

Surroundings otherwise()
{
    return {{0, -1, 0}, {4, 0, 1}, 0.5f, 1.5f};
}

uint64_t hashAfter(Solver& solver, const World& world, double seconds)
{
    run(solver, world, seconds);
    return solver.stateHash();
}

}  // namespace

TEST(Surroundings, AreThoseOfAWorldThatHadThemAllAlong)
{
    const World first = windyWorld({}), other = windyWorld(otherwise());
    Solver changed(gpu(), first), plain(gpu(), other), unchanged(gpu(), first);
    const SolverState start = changed.saveState();
    changed.surround(otherwise());
    EXPECT_EQ(hashAfter(changed, first, 0.5), hashAfter(plain, other, 0.5));
    changed.loadState(start);
    EXPECT_EQ(hashAfter(changed, first, 0.5), hashAfter(unchanged, first, 0.5)) << "a state has its surroundings";
}

TEST(Surroundings, WakeWhatSleeps)
{
    Settings settings;
    settings.sleepSpeed = 0.02f;
    WorldBuilder builder = makeBuilder(settings);
    builder.addCollider(floorPlane());
    addBox(builder, {3, 3, 3}, {Vector3f(0, 1.5f * DIAMETER, 0)});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 2.0);
    ASSERT_EQ(solver.readBodies()[0].velocity.norm(), 0.0f) << "it does not sleep";
    solver.surround({.gravity = {0, 4, 0}});
    run(solver, world, 0.5);
    EXPECT_NEAR(solver.readBodies()[0].velocity.y(), 2.0, 0.05);
}

TEST(Surroundings, MayGiveFluidsEnergy)
{
    Tank tank(6, 6, 6);
    const World world = tank.builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.2);
    solver.surround({.gravity = {0, -19, 0}});
    EXPECT_NO_THROW(run(solver, world, 1.0));
}

TEST(StateEdit, StirsWhatIsNearAsMuchAsItIsGiven)
{
    WorldBuilder builder = makeBuilder(weightless());
    for (int k = 0; k < 8; ++k) {
        Particle particle;
        particle.position = {0.2f * static_cast<float>(k), 0, 0};
        particle.mass = 1.0f + static_cast<float>(k);
        particle.pinned = k == 1;
        builder.addLooseParticle(particle);
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    const Vector3f impulse(0, 6, 1);
    solver.edit([&](StateEdit& edit) {
        EXPECT_FALSE(edit.stir(0, 8, impulse, {0, 5, 0}, 0.5f)) << "nothing is there";
        EXPECT_TRUE(edit.stir(0, 8, impulse, {0.2f, 0, 0}, 0.5f));
    });
    const ParticleState state = solver.readParticles();
    Vector3f sum(0, 0, 0);
    for (size_t i = 0; i < 8; ++i) sum += world.particles[i].mass * state.velocities[i];
    EXPECT_LT((sum - impulse).norm(), 1e-5f);
    EXPECT_EQ(state.velocities[1].norm(), 0.0f) << "it is pinned";
    EXPECT_GT(state.velocities[2].norm(), state.velocities[3].norm()) << "what is nearer gets more";
    EXPECT_EQ(state.velocities[4].norm(), 0.0f) << "it is too far";
}

}  // namespace knuckle::test
