#include <algorithm>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

/// The particles of a body's block, in its order.
std::vector<uint32_t> blockOf(const World& world, uint32_t body)
{
    std::vector<uint32_t> particles;
    const Body& b = world.bodies[body];
    for (uint32_t l = b.linkStart; l < b.linkStart + b.linkCount; ++l) {
        EXPECT_EQ(world.links[l].body, body);
        particles.push_back(world.links[l].particle);
    }
    return particles;
}

/// The bodies of the paper's table 1: {3, 1, 0, 4} and {3, 8, 7} share particle 3.
World table1World(const Settings& settings)
{
    WorldBuilder builder = makeBuilder(settings);
    builder.beginObject("table 1");
    const std::vector<Vector3f> first = {{0, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}, {0, 0, 0.1f}};
    const std::vector<Vector3f> second = {{0.3f, 0, 0}, {0.3f, 0.1f, 0}};
    builder.addBody("first", first, 0);
    const uint32_t body = builder.addBody("second", second, 0);
    builder.shareParticle(0, body);
    builder.shareParticle(0, body);  // a second time changes nothing
    builder.endObject();
    return builder.build();
}

}  // namespace

TEST(Links, TheBlocksOfTable1StandOneAfterTheOtherAndShareAParticle)
{
    const World world = table1World({});
    ASSERT_EQ(world.links.size(), 7u);
    EXPECT_EQ(world.particles.size(), 6u) << "the shared particle exists once";
    EXPECT_EQ(world.bodies[0].linkStart, 0u);
    EXPECT_EQ(world.bodies[0].linkCount, 4u);
    EXPECT_EQ(world.bodies[1].linkStart, 4u);
    EXPECT_EQ(world.bodies[1].linkCount, 3u);
    EXPECT_EQ(blockOf(world, 0), (std::vector<uint32_t>{0, 1, 2, 3}));
    EXPECT_EQ(blockOf(world, 1), (std::vector<uint32_t>{4, 5, 0}));
    EXPECT_EQ(world.particles[0].bodyCount, 2u);
    EXPECT_EQ(world.particles[0].body, 0u);
    EXPECT_EQ(world.particles[5].bodyCount, 1u);
}

TEST(Links, ASharedParticleWeighsItsShareInEachOfItsBodies)
{
    const World split = table1World({});
    EXPECT_FLOAT_EQ(split.links[0].mass, PARTICLE_MASS / 2);
    EXPECT_FLOAT_EQ(split.links[6].mass, PARTICLE_MASS / 2);
    EXPECT_FLOAT_EQ(split.bodies[0].mass, 3.5f * PARTICLE_MASS);
    EXPECT_FLOAT_EQ(split.bodies[1].mass, 2.5f * PARTICLE_MASS);
}

TEST(Links, ASharedParticleWeighsItsWholeMassInEachBodyWhereAsked)
{
    Settings settings = paperSettings();
    settings.splitSharedMass = false;
    const World whole = table1World(settings);
    EXPECT_FLOAT_EQ(whole.links[0].mass, PARTICLE_MASS);
    EXPECT_FLOAT_EQ(whole.bodies[0].mass, 4.0f * PARTICLE_MASS);
    EXPECT_FLOAT_EQ(whole.bodies[1].mass, 3.0f * PARTICLE_MASS);
}

TEST(Links, SplitMassesOfAllLinksSumToTheMassOfAllParticles)
{
    for (JointType type : {JointType::Ball, JointType::Hinge, JointType::Stiff, JointType::Universal}) {
        JointSpec spec;
        spec.type = type;
        const World world = jointedCubes(spec);
        double links = 0.0, bodies = 0.0;
        for (const Link& link : world.links) links += link.mass;
        for (const Body& body : world.bodies) bodies += body.mass;
        // Sums of some 60 numbers, each of which is exact or half an exact one.
        EXPECT_NEAR(links, PARTICLE_MASS * static_cast<double>(world.particles.size()), 1e-4) << jointTypeName(type);
        EXPECT_NEAR(bodies, links, 1e-4) << jointTypeName(type);
    }
}

TEST(Links, OffsetsOfABodySumToZeroByWeight)
{
    JointSpec spec;
    spec.type = JointType::Hinge;
    spec.limitSide = 1;
    const World world = jointedCubes(spec);
    for (const Body& body : world.bodies) {
        Eigen::Vector3d sum = Eigen::Vector3d::Zero();
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const Link& link = world.links[l];
            sum += double(link.mass) * link.restOffset.cast<double>();
            EXPECT_LT((link.restOffset + body.restCentre - world.particles[link.particle].restPosition).norm(), 1e-6f);
        }
        // Each offset is rounded once, by at most 2^-25 of its size, below 0.4 m: 32 x 1e-8.
        EXPECT_LT(sum.norm(), 4e-7) << body.name;
    }
}

TEST(Links, AParticleSharedWithAFixedBodyWeighsItsShare)
{
    JointSpec spec;
    spec.type = JointType::Hinge;
    const World world = jointedCubes(spec, {}, Motion::Fixed);
    const Body& free = world.bodies[1];
    // 27 particles of its own at 2 diameters, and half of the hinge's three at the origin.
    EXPECT_NEAR(free.mass, 28.5 * PARTICLE_MASS, 1e-4);
    EXPECT_NEAR(free.restCentre.x(), 2 * DIAMETER * 27.0 / 28.5, 1e-6);
}

}  // namespace knuckle::test
