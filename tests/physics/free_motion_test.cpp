#include <cmath>

#include "tests/physics/physics_fixture.h"

namespace knuckle::test {

TEST(FreeMotion, AParticleFallsAsTheContinuumSays)
{
    WorldBuilder builder = makeBuilder();
    Particle particle;
    particle.velocity = {2, 3, 0};
    builder.addLooseParticle(particle);
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    const Vector3f x = solver.readParticles().positions[0];
    // Second-order steps of 1/240 s are exact for constant acceleration except at the start, which is first order: an
    // error of about g h^2, 1.7e-4 m, after 1 s. A first-order method errs by g h / 2 in velocity, 0.02 m after 1 s.
    EXPECT_NEAR(x.x(), 2.0, 1e-5);                                  // measured 1.6e-6
    EXPECT_NEAR(x.y(), 3.0 - 0.5 * GRAVITY, 2e-4 * 0.5 * GRAVITY);  // measured 2.5e-5
}

TEST(FreeMotion, ACubeFallsAsTheContinuumSays)
{
    WorldBuilder builder = makeBuilder();
    addBox(builder, {3, 3, 3});
    const World world = builder.build();
    Solver solver(gpu(), world);
    run(solver, world, 1.0);
    EXPECT_NEAR(solver.readBodies()[0].position.y(), -0.5 * GRAVITY, 1.5e-4 * 0.5 * GRAVITY);  // measured 2e-5
}

TEST(FreeMotion, ACubeKeepsItsSpin)
{
    for (RotationMethod rotation : {RotationMethod::Quaternion, RotationMethod::Householder, RotationMethod::Higham}) {
        Settings settings = weightless();
        settings.rotation = rotation;
        WorldBuilder builder = makeBuilder(settings);
        addBox(builder, {3, 3, 3}, {}, {0, 0, 0}, {0, 10, 0});
        const World world = builder.build();
        Solver solver(gpu(), world);
        run(solver, world, 5.0);
        const Vector3f spin = solver.readBodies()[0].angularVelocity;
        EXPECT_NEAR(spin.norm(), 10.0, 0.1) << "rotation method " << static_cast<int>(rotation);
        EXPECT_NEAR(spin.normalized().y(), 1.0, 1e-6);  // measured 0
    }
}

/// Runs 5 s of free tumbling. Momentum: only rounding may change it, by 1e-4 of the sum of m |v|. Angular momentum:
/// BDF2 and the remaining errors of joints' iterations cost a share of it, at most `angularShare`.
void expectConserved(const World& world)
{
    Solver solver(gpu(), world);
    const Totals before = totals(world, solver.readParticles());
    run(solver, world, 5.0);
    const Totals after = totals(world, solver.readParticles());
    EXPECT_LT((after.momentum - before.momentum).norm(), 1e-4 * before.speedSum);
    EXPECT_LT((after.angularMomentum - before.angularMomentum).norm(), 0.005 * before.angularMomentum.norm())
        << "before " << before.angularMomentum.transpose() << ", after " << after.angularMomentum.transpose();
}

TEST(FreeMotion, JointedPairsKeepMomentumAndAngularMomentum)
{
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal}) {
        SCOPED_TRACE(static_cast<int>(type));
        expectConserved(jointedPair(type, weightless(), {}, {0.3f, 0.1f, -0.2f}, {0.5f, 1.0f, 2.0f}));
    }
}

TEST(FreeMotion, AChainOfUnlikeBodiesKeepsMomentumAndAngularMomentum)
{
    // A tree of bodies as in a ragdoll: a trunk and four limbs of two bodies each.
    WorldBuilder builder = makeBuilder(weightless());
    builder.beginObject("figure");
    const uint32_t trunk = builder.addBody("trunk", boxLattice({3, 5, 3}, DIAMETER), 0);
    for (float side : {-1.0f, 1.0f})
        for (float height : {-0.2f, 0.2f}) {
            uint32_t parent = trunk;
            for (int k = 0; k < 2; ++k) {
                const float x = side * (0.35f + 0.4f * static_cast<float>(k));
                std::vector<Vector3f> limb = boxLattice({3, 2, 2}, DIAMETER);
                for (Vector3f& p : limb) p += Vector3f(x, height, 0);
                const uint32_t body = builder.addBody("limb", limb, 0);
                JointSpec joint;
                joint.type = k == 0 ? JointType::Ball : JointType::Hinge;
                joint.anchor = {x - side * 0.2f, height, 0};
                joint.along = {side, 0, 0};
                builder.addJoint(parent, body, joint);
                parent = body;
            }
        }
    builder.endObject({}, {0.2f, -0.1f, 0.3f}, {1.0f, 2.0f, 0.5f});
    expectConserved(builder.build());
}

}  // namespace knuckle::test
