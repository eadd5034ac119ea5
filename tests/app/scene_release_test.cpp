#include <algorithm>
#include <cmath>

#include "tests/app/one_object_scene.h"

namespace knuckle::test {

namespace {

std::vector<uint32_t> heldIn(const World& world)
{
    std::vector<uint32_t> held;
    for (uint32_t b = 0; b < world.bodies.size(); ++b)
        if (world.bodies[b].motion == Motion::Fixed) held.push_back(b);
    return held;
}

}  // namespace

TEST(SceneRelease, SaysUntilWhenWhatIsHeldStays)
{
    const World box = worldOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"time": 2}})");
    EXPECT_EQ(heldIn(box), std::vector<uint32_t>{0});
    EXPECT_EQ(box.bodies[0].releaseTime, 2.0f);
    const World chain = worldOf(R"({"type": "joined", "bodies": 5, "hold": "both", "release": {"time": 0.5}})");
    EXPECT_EQ(heldIn(chain), (std::vector<uint32_t>{0, 4}));
    for (const uint32_t b : {0u, 4u}) EXPECT_EQ(chain.bodies[b].releaseTime, 0.5f);
}

TEST(SceneRelease, ThrowsWhatItSays)
{
    const World world = worldOf(R"({"type": "rigid", "shape": "box", "fixed": true, "velocity": [9, 9, 9], "release": {
        "time": 2, "velocity": [1, 2, 3], "spin": [4, 5, 6], "appears": true}, "repeat": {"counts": [2, 1, 1]}})");
    for (const Body& body : world.bodies) {
        EXPECT_EQ(body.throwVelocity, Vector3f(1, 2, 3));
        EXPECT_EQ(body.throwSpin, Vector3f(4, 5, 6));
        EXPECT_TRUE(body.absent);
    }
    const World plain = worldOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"time": 2}})");
    EXPECT_FALSE(isThrown(plain.bodies[0]));
    EXPECT_EQ(complaintOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"velocity": [1, 0, 0]}})"),
              "/objects/0/release/velocity: is for what is `fixed` until the release's `time`; give both, or take it "
              "away");
    EXPECT_EQ(complaintOf(R"({"type": "rigid", "shape": "box", "motion": {"keys": [{"time": 0}, {"time": 1}]},
                              "release": {"time": 1, "appears": true}})"),
              "/objects/0/release/appears: is for what is `fixed` until the release's `time`; give both, or take it "
              "away");
    EXPECT_EQ(complaintOf(R"({"type": "joined", "hold": "first", "release": {"time": 1, "spin": [1, 0, 0]}})"),
              "/objects/0/release/spin: is for an object of type \"rigid\"; take it away");
}

TEST(SceneRelease, WithoutOneWhatIsHeldStaysForEver)
{
    for (const char* object : {R"({"type": "rigid", "shape": "sphere", "radius": 0.2, "fixed": true})",
                               R"({"type": "joined", "hold": "first", "release": {}})"}) {
        const World world = worldOf(object);
        EXPECT_TRUE(std::isinf(world.bodies[0].releaseTime)) << object;
        EXPECT_TRUE(neverResponds(world.bodies[0])) << object;
    }
}

TEST(SceneRelease, AnActorIsHeldAsAWholeOrByBodiesOfItAndEachCopyIs)
{
    const World whole = worldOf(R"({"type": "actor", "file": "FILE", "fixed": true, "release": {"time": 1},
                                    "repeat": {"counts": [2, 1, 1]}})");
    EXPECT_EQ(heldIn(whole).size(), whole.bodies.size());
    const World hung = worldOf(R"({"type": "actor", "file": "FILE", "hold": ["hand.L", "foot.R"],
                                   "repeat": {"counts": [2, 1, 1]}})");
    std::vector<std::string> names;
    for (const uint32_t b : heldIn(hung)) names.push_back(hung.bodies[b].name);
    std::ranges::sort(names);
    EXPECT_EQ(names, (std::vector<std::string>{"foot.R", "foot.R", "hand.L", "hand.L"}));
}

TEST(SceneRelease, EachCopyIsLetGoLaterThanTheOneBeforeIt)
{
    const World boxes = worldOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"time": 2},
        "repeat": {"counts": [2, 2, 2], "delay": [0.25, 4, 1]}})");
    std::vector<float> times;
    for (const Body& body : boxes.bodies) times.push_back(body.releaseTime);
    EXPECT_EQ(times, (std::vector<float>{2, 2.25f, 3, 3.25f, 6, 6.25f, 7, 7.25f}));
}

TEST(SceneRelease, ACopyThatMovesLaterIsLetGoAtTheSamePlaceOfItsClip)
{
    const World world = worldOf(R"({"type": "actor", "file": "FILE", "animation": {"clip": "dance", "start": 1,
        "speed": 2, "then": [{"at": 3, "clip": "dance"}]}, "release": {"clipTime": 4},
        "repeat": {"counts": [2, 1, 1], "delay": [1, 0, 0]}})");
    const Animation &first = world.animations[0], &second = world.animations[1];
    EXPECT_EQ(first.plays[0].start, 1.0f);
    EXPECT_EQ(second.plays[0].start, 7.0f) << "a round of 8 s before";
    EXPECT_EQ(second.plays[1].at, 4.0f);
    EXPECT_EQ(world.bodies[world.objects[first.object].bodyStart].releaseTime, 1.5f);
    EXPECT_EQ(world.bodies[world.objects[second.object].bodyStart].releaseTime, 2.5f);
    const World lift = worldOf(R"({"type": "rigid", "shape": "box", "motion": {"loop": false, "keys": [{"time": 0},
        {"time": 1, "position": [0, 2, 0]}]}, "repeat": {"counts": [2, 1, 1], "delay": [0.5, 0, 0]}})");
    const auto height = [&](double time) { return bodyPlaces(lift, lift.animations[1], time)[0].translation.y(); };
    EXPECT_EQ(height(0.25), height(0)) << "it waits";
    EXPECT_NEAR(height(1.0) - height(0), 1.0f, 1e-5f);
}

TEST(SceneRelease, MistakesAreToldInOneLine)
{
    EXPECT_EQ(
        complaintOf(R"({"type": "rigid", "shape": "box", "release": {"time": 1}})"),
        "/objects/0/release: is for what is held or moved; set `fixed`, `hold` or `motion` as well, or take it away");
    EXPECT_EQ(
        complaintOf(R"({"type": "joined", "release": {"time": 1}})"),
        "/objects/0/release: is for what is held or moved; set `fixed`, `hold` or `motion` as well, or take it away");
    EXPECT_EQ(complaintOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"time": -1}})"),
              "/objects/0/release/time: -1 is below the minimum 0 [s]");
    EXPECT_EQ(complaintOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": 2})"),
              "/objects/0/release: is 2 (a number), must be an object");
    EXPECT_EQ(complaintOf(R"({"type": "joined", "bodies": 4, "joints": ["hinge"], "hold": "both",
                              "release": {"time": 1}, "limits": {"bend": [-10, 10]}})"),
              "/objects/0/release: a chain that is held at both ends and has limits is a loop, and cannot be let go; "
              "hold one end, or take the limits away");
    EXPECT_EQ(complaintOf(R"({"type": "rigid", "shape": "box", "fixed": true, "release": {"time": 1}})",
                          R"("solver": "paper", )"),
              "the paper's solver lets nothing go; take `release` away, or use solver method impulse");
    EXPECT_EQ(complaintOf(R"({"type": "cloth", "repeat": {"counts": [2, 1, 1], "delay": [1, 0, 0]}})"),
              "/objects/0/repeat/delay: is for what is moved or let go; take it away");
    EXPECT_EQ(complaintOf(R"({"type": "actor", "file": "FILE", "hold": ["hand.l"]})"),
              "/objects/0/hold/0: there is no body \"hand.l\"; did you mean \"hand.L\"?");
}

}  // namespace knuckle::test
