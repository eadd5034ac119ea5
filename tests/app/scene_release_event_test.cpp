#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

/// A dancing figure with a release, and further entries of `objects`.
std::string dancer(const std::string& release, const std::string& more = "")
{
    return R"({"type": "actor", "file": "FILE", "name": "dancer", "animation": {"clip": "dance"}, "release": )" +
           release + "}" + more;
}

const std::string CRATES = R"(, {"type": "rigid", "shape": "box", "size": [0.1, 0.1, 0.1], "name": "crate",
    "position": [0, 5, 0], "repeat": {"counts": [3, 1, 1]}})";
constexpr uint32_t CRATE = 8;  ///< Particles of a crate.

uint32_t sizeOf(const Release& release)
{
    return release.endParticle - release.firstParticle;
}

}  // namespace

TEST(SceneReleaseEvent, SaysWhatLetsGoOfWhat)
{
    const World world = worldOf(dancer(R"([{"impulse": 40}, {"impulse": 15, "below": "forearm.L"}, {"region":
        {"shape": "box", "size": [1, 2, 3], "position": [4, 5, 6], "rotation": [0, 90, 0]}, "below": "thigh.R"}])"));
    ASSERT_EQ(world.releases.size(), 3u);
    const Release &whole = world.releases[0], &arm = world.releases[1], &leg = world.releases[2];
    EXPECT_EQ(whole.cause, ReleaseCause::Impulse);
    EXPECT_EQ(whole.impulse, 40.0f);
    EXPECT_EQ(whole.bodies.size(), world.bodies.size());
    EXPECT_EQ(arm.impulse, 15.0f);
    for (const uint32_t b : arm.bodies)
        EXPECT_TRUE(world.bodies[b].name == "forearm.L" || world.bodies[b].name == "hand.L") << world.bodies[b].name;
    EXPECT_EQ(arm.bodies.size(), 2u);
    EXPECT_EQ(leg.cause, ReleaseCause::Region);
    EXPECT_EQ(leg.bodies.size(), 3u);
    EXPECT_EQ(leg.region.halfExtents, Vector3f(0.5f, 1, 1.5f));
    EXPECT_EQ(leg.region.position, Vector3f(4, 5, 6));
    EXPECT_LT((leg.region.orientation * Vector3f(0, 0, 1) - Vector3f(1, 0, 0)).norm(), 1e-5f);
    for (const Body& body : world.bodies) EXPECT_TRUE(mayBeLetGo(body)) << body.name;
}

TEST(SceneReleaseEvent, ATouchIsOfAllCopiesOrOfOne)
{
    const World all = worldOf(dancer(R"({"touch": "crate"})", CRATES));
    ASSERT_EQ(all.releases.size(), 1u);
    EXPECT_EQ(all.releases[0].cause, ReleaseCause::Touch);
    EXPECT_EQ(sizeOf(all.releases[0]), 3 * CRATE);
    const World one = worldOf(dancer(R"({"touch": "crate_2"})", CRATES));
    EXPECT_EQ(sizeOf(one.releases[0]), CRATE);
    EXPECT_EQ(one.bodies[one.particles[one.releases[0].firstParticle].body].object, 2u) << "behind the dancer";
    // Two objects of one name give two releases; whichever happens first lets go. Ropes come last.
    const World two = worldOf(dancer(R"({"touch": "thing"})", R"(, {"type": "rigid", "shape": "box", "name": "thing",
        "position": [0, 5, 0]}, {"type": "rope", "name": "thing", "from": [0, 6, 0], "to": [1, 6, 0]})"));
    ASSERT_EQ(two.releases.size(), 2u);
    EXPECT_EQ(two.particles[two.releases[0].firstParticle].bodyCount, 1u);
    EXPECT_EQ(two.particles[two.releases[1].firstParticle].bodyCount, 0u);
    // Each copy of a dancer has its own release, by the other copies.
    const World many = worldOf(R"({"type": "actor", "file": "FILE", "name": "dancer", "animation": {"clip": "dance"},
        "repeat": {"counts": [2, 1, 1]}, "release": {"touch": "dancer"}})");
    ASSERT_EQ(many.releases.size(), 2u);
    EXPECT_EQ(many.releases[1].bodies[0], many.objects[1].bodyStart);
    EXPECT_EQ(sizeOf(many.releases[1]), many.particles.size());
}

TEST(SceneReleaseEvent, WhatIsHeldIsLetGoAsWell)
{
    const World world = worldOf(R"({"type": "actor", "file": "FILE", "hold": ["hand.L"], "release": {"impulse": 5}})");
    ASSERT_EQ(world.releases.size(), 1u);
    for (const Body& body : world.bodies) {
        EXPECT_FALSE(neverResponds(body)) << body.name;
        EXPECT_EQ(mayBeLetGo(body), body.name == "hand.L") << body.name;
    }
}

TEST(SceneReleaseEvent, MistakesAreToldInOneLine)
{
    const std::string at = "/objects/0/release";
    const struct {
        std::string object, complaint;
    } cases[] = {
        {dancer(R"({"touch": "crte"})", CRATES), at + "/touch: there is no object \"crte\"; did you mean \"crate\"?"},
        {dancer(R"([{"time": 1}, {"touch": "sea"}])", R"(, {"type": "fluid", "shape": "box", "name": "sea"})"),
         at + "/1/touch: \"sea\" is a fluid, which nothing touches; name something solid, or give a `region`"},
        {dancer(R"({"impulse": -4})"), at + "/impulse: -4 is below the minimum 0 [N s]"},
        {dancer(R"({"region": {"shape": "box"}})"), at + "/region: \"size\" is missing; add it: "},
        {dancer(R"({"region": {"shape": "sphere", "radius": 0}})"), at + "/region/radius: 0 must be above 0 [m]"},
        {dancer(R"({"region": {"shape": "cone", "size": [1, 1, 1]}})"), at + "/region/shape: "},
        {dancer(R"({"impulse": 4, "below": "hadn.L"})"),
         at + "/below: there is no body \"hadn.L\"; did you mean \"hand.L\"?"},
        {dancer(R"({"impulse": 4, "touch": "dancer"})"), at + ": has `impulse` and `touch`; give one of them"},
        {dancer(R"({"time": 4, "region": {"shape": "sphere", "radius": 1}})"),
         at + ": has `time` and `region`; give one of them"},
        {R"({"type": "actor", "file": "FILE", "release": {"impulse": 4}})",
         at + ": is for what is held or animated; set `fixed`, `hold` or `animation`, or take it away"},
    };
    for (const auto& wrong : cases)
        EXPECT_TRUE(complaintOf(wrong.object).starts_with(wrong.complaint)) << complaintOf(wrong.object) << "\n"
                                                                            << wrong.complaint;
    EXPECT_EQ(complaintOf(R"({"type": "actor", "file": "FILE", "fixed": true, "release": {"impulse": 4}})",
                          R"("solver": "paper", )"),
              "the paper's solver lets nothing go; take `release` away, or use solver method impulse");
}

}  // namespace knuckle::test
