#include <algorithm>
#include <limits>

#include "tests/solver/joint/joined_world.h"
#include "tests/solver/joint/joint_fixture.h"

namespace knuckle::test {

namespace {

/// Chains of four and rings of four, more than the threads of a work group; the strength of each joint is random.
World drawnWorld()
{
    std::vector<Joining> joints;
    constexpr uint32_t GROUPS = 21;
    for (uint32_t g = 0; g < GROUPS; ++g)
        for (uint32_t k = 0; k < (g % 3 == 0 ? 4u : 3u); ++k)
            joints.push_back({4 * g + k, 4 * g + (k + 1) % 4, static_cast<JointType>((g + k) % 3)});
    World world = joinedWorld(4 * GROUPS, joints);
    Random random(71);
    for (Joint& joint : world.joints) {
        // Rows get impulses of up to 0.1 kg m and 0.01 kg m2.
        const float h = world.settings.timeStep / static_cast<float>(world.settings.substeps);
        joint.strength.force = random.between(0.05f, 0.4f) / (h * h);
        if (random.between(0, 1) < 0.5f) joint.strength.torque = random.between(0.004f, 0.03f) / (h * h);
    }
    return world;
}

/// The random world with random loads, ready for one dispatch of the kernel.
struct LoadedJoints {
    explicit LoadedJoints(uint32_t order) : fixture(drawnWorld()), joints(fixture.trees().all())
    {
        Stages& s = fixture.stages;
        infos = s.joints.jointInfo.download();
        const float h = s.parameters.substepTime;
        lastLoads = randomVectors(s.joints.jointLoads.size(), 0.1f / (h * h), 72);
        for (size_t j = 0; j < joints.size(); ++j) {
            gpu::vec4& torque = lastLoads[2 * j + 1];
            torque = packed(Vector3f(0.1f * vec3(torque)));
        }
        fill(s.joints.jointLoads, lastLoads);
        fixture.setAssemblies(0, order);
    }
    double squaredTime(double factor) const
    {
        const double h = fixture.stages.parameters.substepTime;
        return factor * h * h;
    }
    /// A joint's load over its strength: the mean of its loads now and a substep ago.
    double loadOf(size_t j, double factor) const
    {
        if (joints[j].freedom == JOINT_NONE) return 0.0;
        const JointStrength& strength = fixture.world.joints[joints[j].joint].strength;
        const auto mean = [&](const gpu::vec4& now, const gpu::vec4& before) {
            return 0.5 * (vec3(now).cast<double>() / squaredTime(factor) + vec3(before).cast<double>()).norm();
        };
        const uint32_t row = infos[j].row;
        return std::max(mean(fixture.rows[row], lastLoads[2 * j]) / strength.force,
                        mean(fixture.angularRows[row], lastLoads[2 * j + 1]) / strength.torque);
    }
    /// For each tree the most loaded joint, if its load is too large.
    std::vector<bool> wanted(double factor) const
    {
        std::vector<bool> torn(joints.size());
        const auto loops = static_cast<uint32_t>(fixture.trees().joints.size());
        for (const JointTrees::Tree& tree : fixture.trees().trees) {
            size_t worst = joints.size();
            double most = 1.0;
            const auto look = [&](size_t j) {
                if (loadOf(j, factor) <= most) return;
                most = loadOf(j, factor);
                worst = j;
            };
            for (uint32_t j = tree.first; j < tree.end; ++j) look(j);
            for (uint32_t l = tree.firstLoop; l < tree.loopEnd; ++l) look(loops + l);
            if (worst < torn.size()) torn[worst] = true;
        }
        return torn;
    }
    void run()
    {
        fixture.dispatch(fixture.load("joint/joint_tear", {{"ANGULAR", "1"}}),
                         (fixture.stages.parameters.jointTreeCount + TREE_GROUP_SIZE - 1) / TREE_GROUP_SIZE);
        gpu().checkErrors();
    }

    JointFixture fixture;
    std::vector<JointTrees::Joint> joints;
    std::vector<gpu::Joint> infos;
    std::vector<gpu::vec4> lastLoads;
};

TEST(JointTearKernel, OfEachTreeTheJointThatBearsMostTooMuchLetsGo)
{
    size_t trees = 0, letGo = 0;
    for (const uint32_t order : {1u, 2u}) {
        LoadedJoints loaded(order);
        loaded.run();
        const auto freedoms = loaded.fixture.stages.joints.jointFreedoms.download();
        const std::vector<bool> torn = loaded.wanted(order == 2 ? 4.0 / 9.0 : 1.0);
        for (size_t j = 0; j < torn.size(); ++j)
            EXPECT_EQ(freedoms[j], torn[j] ? JOINT_NONE : loaded.joints[j].freedom)
                << "joint " << j << ", order " << order;
        trees += loaded.fixture.trees().trees.size();
        letGo += static_cast<size_t>(std::count(torn.begin(), torn.end(), true));
    }
    EXPECT_GT(letGo, trees / 4);
    EXPECT_LT(letGo, trees) << "some hold";
}

TEST(JointTearKernel, WhatIsTornHoldsNothingAndItsParticlesStayWithTheirFirstBody)
{
    LoadedJoints loaded(1);
    JointFixture& fixture = loaded.fixture;
    const auto linksBefore = fixture.stages.bodies.particleLinks.download();
    loaded.run();
    const std::vector<bool> torn = loaded.wanted(1.0);
    const auto rows = fixture.stages.bodies.rowImpulses.download(),
               angular = fixture.stages.bodies.rowAngularImpulses.download();
    const auto links = fixture.stages.bodies.particleLinks.download();
    std::vector<bool> lost(links.size());
    for (size_t j = 0; j < loaded.joints.size(); ++j) {
        for (const uint32_t row : {loaded.infos[j].row, loaded.infos[j].parentRow}) {
            if (row == NO_INDEX) continue;
            EXPECT_EQ(vec3(rows[row]), torn[j] ? Vector3f(0, 0, 0) : vec3(fixture.rows[row])) << "joint " << j;
            EXPECT_EQ(vec3(angular[row]), torn[j] ? Vector3f(0, 0, 0) : vec3(fixture.angularRows[row]));
        }
        for (const uint32_t particle : loaded.joints[j].particles) lost[particle] = lost[particle] || torn[j];
    }
    for (size_t i = 0; i < links.size(); ++i)
        EXPECT_EQ(links[i].y, lost[i] ? 1u : linksBefore[i].y) << "particle " << i;
}

TEST(JointTearKernel, LoadsOfTheSubstepAreKeptForTheNext)
{
    LoadedJoints loaded(1);
    loaded.run();
    const auto loads = loaded.fixture.stages.joints.jointLoads.download();
    for (size_t j = 0; j < loaded.joints.size(); ++j) {
        if (loaded.joints[j].freedom == JOINT_NONE) continue;
        const Vector3d wanted = vec3(loaded.fixture.rows[loaded.infos[j].row]).cast<double>() / loaded.squaredTime(1.0);
        // A division, and a square of a float.
        EXPECT_LT((vec3(loads[2 * j]).cast<double>() - wanted).norm(), 4 * EPSILON * wanted.norm()) << "joint " << j;
    }
}

}  // namespace

}  // namespace knuckle::test
