#include <algorithm>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

JointSpec specOf(JointType type, int limitSide = 0)
{
    JointSpec spec;
    spec.type = type;
    spec.name = "joint";
    spec.limitSide = limitSide;
    return spec;
}

/// Particles of all bodies that more than one body shares.
uint32_t sharedCount(const World& world)
{
    uint32_t count = 0;
    for (const Particle& p : world.particles) count += p.bodyCount > 1;
    return count;
}

}  // namespace

TEST(Builder, SubstepsFollowTheDiameterUnlessTold)
{
    const auto substeps = [](float radius, const Settings& settings = {}) {
        WorldBuilder builder(radius, settings);
        builder.addMaterial({});
        builder.addLooseParticle({});
        return builder.build().settings.substeps;
    };
    // 4.5 m/s are 75 mm in a step of 1/60 s: 3.75 fifths of 0.1 m, 9.4 of 0.04 m.
    EXPECT_EQ(substeps(0.05f), 4u);
    EXPECT_EQ(substeps(0.02f), 10u);
    EXPECT_EQ(substeps(0.5f), 4u);
    EXPECT_EQ(substeps(0.001f), 16u);
    Settings told;
    told.substeps = 3;
    EXPECT_EQ(substeps(0.001f, told), 3u);
}

TEST(Builder, EachJointTypeSharesItsNumberOfParticles)
{
    // Two cubes of 27 with a free layer between them: every joint particle is a new one.
    const struct {
        JointType type;
        int limits;
        uint32_t shared, particles, bodies;
    } rows[] = {
        {JointType::Ball, 0, 1, 55, 2},  {JointType::Hinge, 0, 3, 57, 2},     {JointType::Hinge, 1, 3, 59, 2},
        {JointType::Stiff, 0, 4, 58, 2}, {JointType::Universal, 0, 5, 59, 3},
    };
    for (const auto& row : rows) {
        const World world = jointedCubes(specOf(row.type, row.limits));
        SCOPED_TRACE(jointTypeName(row.type));
        EXPECT_EQ(sharedCount(world), row.shared);
        EXPECT_EQ(world.particles.size(), row.particles);
        EXPECT_EQ(world.bodies.size(), row.bodies);
        EXPECT_EQ(world.assemblyCount, 1u);
    }
}

TEST(Builder, TwoBodiesShareAJointsParticlesAndThreeTheCrossingOfAUniversalJoint)
{
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal}) {
        const World world = jointedCubes(specOf(type));
        for (const Joint& joint : world.joints)
            for (uint32_t p : joint.particles) {
                const bool crossing = type == JointType::Universal && world.particles[p].position.norm() < 1e-6f;
                EXPECT_EQ(world.particles[p].bodyCount, crossing ? 3u : 2u) << jointTypeName(type);
            }
    }
}

TEST(Builder, LimitingParticlesBelongToTheFirstBodyAlone)
{
    const World world = jointedCubes(specOf(JointType::Hinge, 1));
    EXPECT_EQ(world.bodies[0].linkCount, 27u + 3u + 2u);
    EXPECT_EQ(world.bodies[1].linkCount, 27u + 3u);
}

TEST(Builder, TheCrossOfAUniversalJointIsABodyThatTouchesNothingOfItsAssembly)
{
    const World world = jointedCubes(specOf(JointType::Universal));
    const Body& cross = world.bodies.at(2);
    EXPECT_TRUE(cross.isCross);
    EXPECT_EQ(jointCount(world), 1u);
    EXPECT_EQ(cross.name, "joint.cross");
    EXPECT_EQ(cross.linkCount, 5u);
    for (uint32_t i = 0; i < world.particles.size(); ++i) {
        bool inCross = false;
        for (uint32_t l = cross.linkStart; l < cross.linkStart + cross.linkCount; ++l)
            inCross |= world.links[l].particle == i;
        EXPECT_EQ(world.particles[i].touchesAssembly, !inCross) << "particle " << i;
    }
}

TEST(Builder, ASelfMarginAndAnExemptionHoldForTheOpenObjectOnly)
{
    WorldBuilder builder = makeBuilder();
    for (const char* name : {"plain", "soft"}) {
        builder.beginObject(name);
        builder.addBody("a", cubeAt({-2, 0, 0}), 0);
        const uint32_t b = builder.addBody("b", cubeAt({2, 0, 0}), 0);
        if (std::string(name) == "soft") {
            builder.setSelfMargin(0.5f);
            builder.markCross(b);
        }
        builder.endObject();
    }
    const World world = builder.build();
    for (const Particle& p : world.particles) {
        EXPECT_EQ(p.selfMargin, p.body >= 2 ? 0.5f : 0.0f);
        EXPECT_EQ(p.touchesAssembly, p.body != 3);
    }
}

TEST(Builder, ACrossHasMostOfTheMassThatItShares)
{
    JointSpec spec;
    spec.type = JointType::Universal;
    const World world = jointedCubes(spec);
    std::vector<float> sums(world.particles.size());
    for (const Link& link : world.links) {
        const Particle& particle = world.particles[link.particle];
        sums[link.particle] += link.mass;
        // Six eighths if three bodies share it, six sevenths if two do.
        if (world.bodies[link.body].isCross) {
            EXPECT_NEAR(link.mass, particle.mass * (particle.bodyCount == 3 ? 0.75f : 6.0f / 7.0f), 1e-6f);
        }
    }
    for (size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i], world.particles[i].mass, 1e-6f);
}

TEST(Builder, AJointTakesParticlesThatStandWhereItNeedsThem)
{
    // Cubes side by side: the ball's anchor lies on a face particle of A.
    WorldBuilder builder = makeBuilder();
    builder.beginObject("pair");
    const uint32_t a = builder.addBody("a", cubeAt({-2, 0, 0}), 0), b = builder.addBody("b", cubeAt({1, 0, 0}), 0);
    JointSpec spec;
    spec.anchor = {-1.3f * DIAMETER, 0, 0};  // 0.3 diameters from A's particle
    builder.addJoint(a, b, spec);
    builder.endObject();
    const World world = builder.build();
    EXPECT_EQ(world.particles.size(), 54u);
    const Particle& shared = world.particles[world.joints[0].particles.at(0)];
    EXPECT_LT((shared.position - Vector3f(-DIAMETER, 0, 0)).norm(), 1e-6f);
    EXPECT_EQ(shared.bodyCount, 2u);
}

TEST(Builder, BodiesConnectedByJointsAreOneAssemblyAndLooseParticlesNone)
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("chain");
    for (int k = 0; k < 4; ++k) builder.addBody("link", cubeAt({4.0f * static_cast<float>(k), 0, 0}), 0);
    JointSpec spec;
    // From the last to the first, so that numbers must spread through the chain.
    for (uint32_t k : {2u, 0u}) {
        spec.anchor = {(4.0f * static_cast<float>(k) + 2.0f) * DIAMETER, 0, 0};
        builder.addJoint(k + 1, k, spec);
    }
    builder.endObject();
    builder.addLooseParticle({});
    const World world = builder.build();
    EXPECT_EQ(world.assemblyCount, 2u);
    EXPECT_EQ(world.bodies[0].assembly, 0u);
    EXPECT_EQ(world.bodies[1].assembly, 0u);
    EXPECT_EQ(world.bodies[2].assembly, 1u);
    EXPECT_EQ(world.bodies[3].assembly, 1u);
    for (const Link& link : world.links)
        EXPECT_EQ(world.particles[link.particle].assembly, world.bodies[link.body].assembly);
    EXPECT_EQ(world.particles.back().assembly, NO_INDEX);
    EXPECT_EQ(world.particles.back().body, NO_INDEX);
}

TEST(Builder, AnObjectIsPlacedAsAWholeAndTurnsAboutItsMassCentre)
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("cube");
    builder.addBody("cube", cubeAt({2, 0, 0}), 0);
    const Pose pose{{1, 2, 3}, Quaternionf(Eigen::AngleAxisf(0.7f, Vector3f::UnitY()))};
    const Vector3f velocity(1, 0, -1), spin(0, 3, 0);
    EXPECT_EQ(builder.endObject(pose, velocity, spin), 0u);
    const World world = builder.build();
    const Vector3f centre = pose.apply({2 * DIAMETER, 0, 0});
    EXPECT_LT((world.bodies[0].position - centre).norm(), 1e-6f);
    EXPECT_LT(world.bodies[0].rotation.angularDistance(pose.rotation), 1e-6f);
    for (const Particle& p : world.particles) {
        EXPECT_LT((p.position - pose.apply(p.restPosition)).norm(), 1e-6f);
        EXPECT_LT((p.velocity - velocity - spin.cross(p.position - centre)).norm(), 1e-5f);
    }
}

TEST(Builder, AnObjectKnowsItsBodies)
{
    WorldBuilder builder = makeBuilder();
    for (int k = 0; k < 2; ++k) {
        builder.beginObject("pair");
        builder.addBody("a", cubeAt({-2, 0, 0}), 0);
        builder.addBody("b", cubeAt({2, 0, 0}), 0);
        builder.endObject();
    }
    const World world = builder.build();
    ASSERT_EQ(world.objects.size(), 2u);
    EXPECT_EQ(world.objects[1].bodyStart, 2u);
    EXPECT_EQ(world.objects[1].bodyCount, 2u);
}

TEST(Builder, AParticleWeighsDensityTimesTheCubeOfTheDiameter)
{
    WorldBuilder builder = makeBuilder();
    Material lead;
    lead.density = 11340.0f;
    const uint32_t heavy = builder.addMaterial(lead);
    builder.beginObject("shot");
    builder.addBody("shot", std::vector<Vector3f>{{0, 0, 0}}, heavy);
    builder.endObject();
    EXPECT_NEAR(builder.build().particles[0].mass, 11.34f, 1e-4f);
}

}  // namespace knuckle::test
