#include <map>
#include <numbers>

#include "sim/world/fingerprint/fingerprint.h"
#include "tests/app/one_object_scene.h"

namespace knuckle::test {
namespace {

const char* const ROPE = R"({ "type": "rope", "from": [0, 1, 0], "to": [0, 2, 0])";
const char* const CLOTH = R"({ "type": "cloth", "size": [0.4, 0.3])";
const char* const SOFT = R"({ "type": "soft", "shape": "box", "size": [0.4, 0.3, 0.5])";
const char* const SAND = R"({ "type": "grains", "shape": "box", "size": [0.2, 0.2, 0.2])";
const char* const BOX = R"({ "type": "rigid", "shape": "box")";

std::string with(const char* object, const char* draw)
{
    return std::string(object) + R"(, "draw": ")" + draw + "\" }";
}

/// Everything is drawn as it can be, but for one material's.
std::string materials(const char* draw)
{
    return std::string(R"("materials": { "default": { "draw": ")") + draw + R"(" }, "dots": {} }, )";
}

size_t drawnCount(const World& world)
{
    const DrawnMatter& d = world.drawn;
    return d.cloth.size() + d.ropes.size() + d.soft.size() + d.grains.size();
}

TEST(SceneMatter, IsDrawnAsItsOwnDrawOrItsMaterialSays)
{
    for (const auto& [object, draw] : {std::pair(ROPE, "shape"), std::pair(CLOTH, "surface"),
                                       std::pair(SOFT, "surface"), std::pair(SAND, "shape")}) {
        EXPECT_EQ(drawnCount(worldOf(std::string(object) + "}")), 0u) << object;
        EXPECT_EQ(drawnCount(worldOf(with(object, draw))), 1u) << object;
        EXPECT_EQ(drawnCount(worldOf(std::string(object) + "}", materials(draw))), 1u) << object;
        EXPECT_EQ(drawnCount(worldOf(with(object, "particles"), materials(draw))), 0u) << object;
        EXPECT_EQ(drawnCount(worldOf(std::string(object) + R"(, "material": "dots" })", materials(draw))), 0u);
        EXPECT_EQ(fingerprint(worldOf(with(object, draw))), fingerprint(worldOf(std::string(object) + "}"))) << object;
        const std::string three = std::string(object) +
                                  R"(, "repeat": { "counts": [3, 1, 1], "spacing": [2, 2, 2] } })";
        EXPECT_EQ(drawnCount(worldOf(three, materials(draw))), 3u) << object;
    }
}

TEST(SceneMatter, OfFluidThatIsNotToBeSeenIsUnseen)
{
    const auto hidden = [](const std::string& more) {
        const World world = worldOf(R"({ "type": "fluid", "shape": "box", "size": [0.2, 0.2, 0.2], "name": "seen",
            "position": [0, 1, 0] }, { "type": "fluid", "shape": "sphere", "radius": 0.2, "position": [2, 1, 0])" +
                                    more + R"( }, { "type": "rigid", "shape": "box", "position": [4, 1, 0] })");
        const LooseGroup& last = world.looseGroups.back();
        size_t own = 0, all = 0;
        for (const ParticleRange& range : world.unseen) {
            all += range.end - range.first;
            if (range.first >= last.first && range.end <= last.end) own += range.end - range.first;
        }
        EXPECT_EQ(own, all);
        EXPECT_TRUE(all == 0 || all == last.end - last.first);
        return all > 0;
    };
    EXPECT_FALSE(hidden(""));
    EXPECT_TRUE(hidden(R"(, "visible": false)"));
}

TEST(SceneMatter, WhatAnObjectDoesNotHaveIsTold)
{
    EXPECT_EQ(complaintOf(with(ROPE, "surface")),
              "/objects/0/draw: a rope has no surface; take \"shape\" or \"particles\"");
    EXPECT_EQ(complaintOf(with(CLOTH, "shape")),
              "/objects/0/draw: cloth has no shape; take \"surface\" or \"particles\"");
    EXPECT_EQ(complaintOf(with(SOFT, "shape")),
              "/objects/0/draw: a soft body has no shape; take \"surface\" or \"particles\"");
    EXPECT_EQ(complaintOf(with(SAND, "surface")),
              "/objects/0/draw: a grain has no surface; take \"shape\" or \"particles\"");
    EXPECT_EQ(complaintOf(with(BOX, "surface")),
              "/objects/0/draw: a rigid box has no surface; take \"shape\" or \"particles\"");
    EXPECT_EQ(complaintOf(std::string(BOX) + "}", materials("surface")),
              "/objects/0/material: \"default\" says \"draw\": \"surface\", and a rigid box has none; give it "
              "\"draw\": \"shape\" or \"particles\", or another material");
    EXPECT_EQ(complaintOf(with(CLOTH, "surfaces")),
              "/objects/0/draw: \"surfaces\" is unknown; did you mean \"surface\"?");
}

TEST(SceneMatter, AMaterialThatIsDrawnInShapeLeavesWhatHasNone)
{
    EXPECT_EQ(drawnCount(worldOf(std::string(CLOTH) + "}", materials("shape"))), 0u);
    EXPECT_EQ(drawnCount(worldOf(std::string(SOFT) + "}", materials("shape"))), 0u);
}

/// The volume inside of a soft body's surface at rest, and whether each of its edges has two sides [m3].
float volumeOf(const World& world)
{
    const SoftHull& hull = *world.drawn.soft.at(0).hull;
    const uint32_t first = world.softBodies[0].particleStart;
    const auto at = [&](uint32_t vertex) {
        Vector3f place = Vector3f::Zero();
        for (size_t k = 0; k < HULL_LINKS; ++k)
            place += hull.vertices[vertex].weights[k] *
                     world.particles[first + hull.vertices[vertex].particles[k]].restPosition;
        return place;
    };
    float sixths = 0.0f;
    std::map<std::pair<uint32_t, uint32_t>, int> edges;
    for (const auto& [a, b, c] : hull.triangles) {
        sixths += at(a).dot(at(b).cross(at(c)));
        for (const auto& edge : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) ++edges[edge];
    }
    for (const auto& [edge, count] : edges) {
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(edges.contains({edge.second, edge.first}));
    }
    return sixths / 6.0f;
}

TEST(SceneMatter, ASoftSurfaceIsClosedAndAsLargeAsItsParticles)
{
    // 8 x 6 x 10 particles of 0.05 m; edges of radius 0.025 m take 4 (1 - pi/4) r^2 of the sum of sides, corners less.
    const float box = 0.4f * 0.3f * 0.5f - (4.0f - std::numbers::pi_v<float>)*0.025f * 0.025f * 1.2f;
    EXPECT_NEAR(volumeOf(worldOf(with(SOFT, "surface"))), box, 0.01f * box);
    // Those of balls and capsules have the mean reach of their particles: more than the cells of their lattice, whose
    // steps they level. A reach that is off by a tenth of the radius makes a third of the volume.
    for (const auto& [shape, most] :
         {std::pair(R"("sphere", "radius": 0.3)", 1.2f), std::pair(R"("sphere", "radius": 0.11)", 1.35f),
          std::pair(R"("capsule", "radius": 0.15, "length": 0.4)", 1.2f)}) {
        const World world = worldOf(std::string(R"({ "type": "soft", "draw": "surface", "shape": )") + shape + "}");
        const float cells = static_cast<float>(world.particles.size()) * 0.05f * 0.05f * 0.05f;
        EXPECT_GT(volumeOf(world), 0.97f * cells) << shape;
        EXPECT_LT(volumeOf(world), most * cells) << shape;
    }
}

TEST(SceneMatter, ASoftModelIsDrawnInItsMesh)
{
    const World figure = worldOf(R"({ "type": "soft", "shape": "mesh", "file": "FILE", "draw": "surface" })");
    ASSERT_EQ(figure.drawn.soft.size(), 1u);
    EXPECT_GT(figure.drawn.soft[0].hull->vertices.size(), 1000u);
}

}  // namespace
}  // namespace knuckle::test
