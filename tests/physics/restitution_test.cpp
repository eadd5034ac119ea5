#include <cmath>
#include <span>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

namespace {

enum class Thing { Grain, Cube, Ball };

WorldBuilder bouncyBuilder(float restitution)
{
    WorldBuilder builder(DIAMETER / 2);
    Material material;
    material.restitution = restitution;
    builder.addMaterial(material);
    builder.addCollider(floorPlane());
    return builder;
}

float lowest(std::span<const Vector3f> positions)
{
    float low = INFINITY;
    for (const Vector3f& p : positions) low = std::min(low, p.y());
    return low - 0.5f * DIAMETER;
}

/// How high something rises again after a fall of about 1 m [m], onto a plane or onto the middle of four particles of a
/// fixed block.
float rebound(Thing thing, float restitution, float fall = 1.0f, bool onBlock = false)
{
    WorldBuilder builder = bouncyBuilder(restitution);
    const auto block = boxLattice({10, 2, 10}, DIAMETER);
    if (onBlock) {
        builder.beginObject("block");
        builder.addBody("block", block, 0, Motion::Fixed);
        builder.endObject({Vector3f(0, -DIAMETER, 0)});
    }
    if (thing == Thing::Grain) {
        Particle grain;
        grain.position = {0, fall + 0.5f * DIAMETER, 0};
        builder.addLooseParticle(grain);
    } else {
        const auto lattice = thing == Thing::Cube ? boxLattice({3, 3, 3}, DIAMETER) : sphereLattice(0.25f, DIAMETER);
        builder.beginObject("thing");
        builder.addBody("thing", lattice, 0);
        builder.endObject({Vector3f(0, fall - lowest(lattice), 0)});
    }
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.5);  // from 1 m it lands after 0.4515 s
    float top = 0.0f;
    for (int k = 0; k < 32; ++k) {
        solver.step();
        const auto positions = solver.readParticles().positions;
        top = std::max(top, lowest(std::span(positions).subspan(onBlock ? block.size() : 0)));
    }
    return top;
}

}  // namespace

TEST(Restitution, WhatFallsByOneMetreRisesToTheSquareOfIt)
{
    // A substep of 1/240 s at 4.43 m/s is 18.5 mm. The speed is that at its start, of a height up to as much less; it
    // rises from where it was stopped, up to half of that from the ground.
    const double way = std::sqrt(2.0 * GRAVITY) / 240.0;
    for (Thing thing : {Thing::Grain, Thing::Cube, Thing::Ball})
        for (float e : {0.0f, 0.5f, 0.8f})
            EXPECT_NEAR(rebound(thing, e), e * e, (e * e + 0.5) * way) << "restitution " << e;
}

TEST(Restitution, WhatFallsOnABlockOfParticlesRisesAsFromAPlane)
{
    // As above; amid four particles it is found at most 0.03 diameters late.
    for (Thing thing : {Thing::Grain, Thing::Cube, Thing::Ball})
        for (float fall = 0.8f; fall < 1.2f; fall += 0.05f) {
            const double way = std::sqrt(2.0 * GRAVITY * double(fall)) / 240.0;
            EXPECT_NEAR(rebound(thing, 0.8f, fall, true), 0.64 * double(fall),
                        (0.64 + 0.5) * way + 0.03 * double(DIAMETER))
                << fall << " m";
        }
}

TEST(Restitution, TwoThatCollideKeepTheirMomentumAndPartAsItSays)
{
    WorldBuilder builder(DIAMETER / 2, weightless());
    for (float restitution : {0.0f, 0.6f}) {
        Material material;
        material.restitution = restitution;
        builder.addMaterial(material);
    }
    addBox(builder, {3, 3, 3}, {Vector3f(-0.4f, 0, 0)}, {1, 0, 0});
    builder.beginObject("bouncy");
    builder.addBody("bouncy", boxLattice({3, 3, 3}, DIAMETER), 1);
    builder.endObject();
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 0.5);
    const auto bodies = solver.readBodies();
    // The larger restitution of the two; equal masses. Four iterations leave (1 - x)(1 - 1.8 x) twice of a mode that
    // converges by x, a hundredth at the half that nine contacts of a cube come to.
    EXPECT_NEAR(bodies[0].velocity.x(), 0.5 * (1 - 0.6), 0.01);
    EXPECT_NEAR(bodies[1].velocity.x(), 0.5 * (1 + 0.6), 0.01);
    EXPECT_NEAR(bodies[0].velocity.x() + bodies[1].velocity.x(), 1.0, 1e-4);
}

TEST(Restitution, AddsNoEnergy)
{
    WorldBuilder builder = bouncyBuilder(0.9f);
    for (int k = 0; k < 12; ++k)
        addBox(builder, {3, 2, 3},
               {Vector3f(0.1f * static_cast<float>(k % 3), 0.4f + 0.35f * static_cast<float>(k), 0),
                Quaternionf(Eigen::AngleAxisf(0.3f * static_cast<float>(k), Vector3f(1, 2, 3).normalized()))});
    const World world = builder.build();
    Solver solver(gpu(), world);
    const auto energy = [&] {
        const ParticleState state = solver.readParticles();
        double sum = 0.0;
        for (size_t i = 0; i < state.positions.size(); ++i) {
            const double height = state.positions[i].y(), speed = state.velocities[i].norm();
            sum += world.particles[i].mass * (0.5 * speed * speed + GRAVITY * height);
        }
        return sum;
    };
    double least = energy();
    for (int k = 0; k < 40; ++k) {
        run(solver, world, 0.1);
        const double now = energy();
        // Without collisions it is kept to 1e-3; bodies that overlap are pushed apart with next to no speed.
        EXPECT_LT(now, 1.01 * least) << "after " << 0.1 * (k + 1) << " s";
        least = std::min(least, now);
    }
}

}  // namespace knuckle::test
