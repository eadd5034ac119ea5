#include "sim/world/builder/parts/clusters.h"

#include <algorithm>
#include <numeric>
#include <set>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

using Clusters = std::vector<std::vector<uint32_t>>;

/// The number of connected parts that the clusters make of the particles.
size_t pieces(const Clusters& clusters, size_t count)
{
    std::vector<uint32_t> piece(count);
    std::iota(piece.begin(), piece.end(), 0u);
    for (bool changed = true; changed;) {
        changed = false;
        for (const auto& members : clusters)
            for (uint32_t i : members)
                for (uint32_t j : members)
                    if (piece[j] > piece[i]) {
                        piece[j] = piece[i];
                        changed = true;
                    }
    }
    return std::set<uint32_t>(piece.begin(), piece.end()).size();
}

World softWorld(const Elasticity& elasticity, const Settings& settings = {})
{
    WorldBuilder builder(DIAMETER / 2, settings);
    Material material;
    material.name = "jelly";
    material.elasticity = elasticity;
    builder.addMaterial(material);
    builder.beginObject("thing");
    builder.addSoftBody("thing", boxLattice({5, 4, 3}, DIAMETER), 0);
    builder.endObject();
    return builder.build();
}

}  // namespace

TEST(Clusters, ABoxIsCutIntoBoxesThatShareALayer)
{
    const Clusters clusters = makeClusters(boxLattice({5, 5, 3}, DIAMETER), DIAMETER);
    ASSERT_EQ(clusters.size(), 4u);
    for (const auto& members : clusters) EXPECT_EQ(members.size(), 27u);
    EXPECT_EQ(pieces(clusters, 75), 1u);
}

TEST(Clusters, EveryParticleThatHasANeighbourIsInOne)
{
    for (const Eigen::Vector3i& counts : {Eigen::Vector3i(4, 6, 2), {1, 8, 1}, {2, 1, 1}, {5, 1, 4}, {7, 7, 7}}) {
        const auto positions = boxLattice(counts, DIAMETER);
        const Clusters clusters = makeClusters(positions, DIAMETER);
        EXPECT_EQ(pieces(clusters, positions.size()), 1u) << counts.transpose();
        for (size_t a = 0; a < clusters.size(); ++a)
            for (size_t b = 0; b < clusters.size(); ++b)
                EXPECT_FALSE(a != b && std::includes(clusters[a].begin(), clusters[a].end(), clusters[b].begin(),
                                                     clusters[b].end()))
                    << counts.transpose();
    }
    EXPECT_TRUE(makeClusters(boxLattice({1, 1, 1}, DIAMETER), DIAMETER).empty());
    EXPECT_TRUE(makeClusters({}, DIAMETER).empty());
}

TEST(Clusters, LimbsThatAreNearButNotConnectedAreNotGlued)
{
    // Two rods one particle wide, side by side with one free place between them, then joined at one end.
    std::vector<Vector3f> positions;
    for (const Vector3f& p : boxLattice({1, 9, 1}, DIAMETER))
        for (float side : {0.0f, 2.0f}) positions.push_back(p + DIAMETER * Vector3f(side, 4, 0));
    EXPECT_EQ(pieces(makeClusters(positions, DIAMETER), positions.size()), 2u);
    positions.emplace_back(DIAMETER, 0, 0);
    const Clusters joined = makeClusters(positions, DIAMETER);
    EXPECT_EQ(pieces(joined, positions.size()), 1u);
    for (const auto& members : joined) {
        const bool low = std::all_of(members.begin(), members.end(),
                                     [&](uint32_t i) { return positions[i].y() < 2.5f * DIAMETER; });
        bool left = false, right = false;
        for (uint32_t i : members) (positions[i].x() < DIAMETER ? left : right) = true;
        EXPECT_TRUE(low || left != right);
    }
}

TEST(Clusters, ParticlesOffTheLatticeAreHeldToo)
{
    const std::vector<Vector3f> positions = {{0, 0, 0}, {1.2f * DIAMETER, 0, 0}, {2.9f * DIAMETER, 0, 0}};
    EXPECT_EQ(pieces(makeClusters(positions, DIAMETER), 3), 1u);
}

TEST(Clusters, TheSharesOfAParticlesMassSumToIt)
{
    const World world = softWorld({});
    std::vector<double> mass(world.particles.size());
    for (const Link& link : world.clusterLinks) mass[link.particle] += link.mass;
    for (size_t i = 0; i < mass.size(); ++i) EXPECT_NEAR(mass[i], PARTICLE_MASS, 1e-6);
    for (const Cluster& cluster : world.clusters) {
        Vector3f moment = Vector3f::Zero();
        for (uint32_t l = cluster.linkStart; l < cluster.linkStart + cluster.linkCount; ++l)
            moment += world.clusterLinks[l].mass * world.clusterLinks[l].restOffset;
        EXPECT_LT(moment.norm(), 1e-6f);
    }
    EXPECT_NE(world.particles[0].assembly, NO_INDEX);
    EXPECT_EQ(world.particles[0].body, NO_INDEX);
}

TEST(Clusters, OutermostPinsHaveHalfTheirMass)
{
    // Of a column, a layer in the middle is strained on both sides, the lowest only above its middle.
    const std::vector<Vector3f> lattice = boxLattice({3, 6, 3}, DIAMETER);
    for (int pinned : {0, 3}) {
        SCOPED_TRACE(pinned);
        WorldBuilder builder(DIAMETER / 2);
        builder.addMaterial({});
        std::vector<uint32_t> pins;
        for (uint32_t i = 0; i < lattice.size(); ++i)
            if (std::lround(lattice[i].y() / DIAMETER + 2.5f) == pinned) pins.push_back(i);
        ASSERT_EQ(pins.size(), 9u);
        builder.beginObject("column");
        builder.addSoftBody("column", lattice, 0, pins);
        builder.endObject();
        const World world = builder.build();
        std::vector<double> mass(world.particles.size());
        for (const Link& link : world.clusterLinks) mass[link.particle] += double(link.mass);
        for (size_t i = 0; i < mass.size(); ++i) {
            const bool half = pinned == 0 && world.particles[i].pinned;
            EXPECT_NEAR(mass[i], double(world.particles[i].mass) * (half ? 0.5 : 1.0), 1e-6);
        }
    }
}

TEST(Clusters, WrongMaterialsGetOneLineEach)
{
    const auto message = [](float Elasticity::*field, float value) {
        Elasticity elasticity;
        elasticity.*field = value;
        return misuseOf([&] { softWorld(elasticity); });
    };
    EXPECT_EQ(message(&Elasticity::stiffness, 0.0f), "material \"jelly\": stiffness 0 Pa must be 1 to 1000000000000");
    EXPECT_EQ(message(&Elasticity::stiffness, NAN), "material \"jelly\": stiffness nan Pa must be 1 to 1000000000000");
    EXPECT_EQ(message(&Elasticity::poissonRatio, 0.5f), "material \"jelly\": Poisson ratio 0.5 must be 0 to 0.45");
    EXPECT_EQ(message(&Elasticity::damping, -1.0f), "material \"jelly\": damping -1 s must be 0 to 1");
    EXPECT_EQ(message(&Elasticity::yield, 11.0f), "material \"jelly\": yield 11 must be 0 to 10");
    EXPECT_EQ(message(&Elasticity::creep, -2.0f), "material \"jelly\": creep -2 1/s must be 0 to 1000");
    EXPECT_EQ(message(&Elasticity::maxDeformation, 3.0f), "material \"jelly\": largest deformation 3 must be 0 to 2");
    EXPECT_EQ(complaintOf([] { softWorld({}, paperSettings()); }),
              "soft body \"thing\": the paper's solver has none; use solver method impulse");
}

TEST(Clusters, BrokenBlocksAreRefused)
{
    World world = softWorld({});
    world.clusters[0].linkCount = 100000;
    EXPECT_EQ(misuseOf([&] { validate(world); }), "soft body \"thing\": its links reach beyond the array");
    world = softWorld({});
    world.clusterLinks[0].particle = 5000;
    EXPECT_EQ(misuseOf([&] { validate(world); }), "soft body \"thing\": a link names another cluster or body");
}

}  // namespace knuckle::test
