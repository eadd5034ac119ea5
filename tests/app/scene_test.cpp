#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "app/files/actor_file.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_places.h"
#include "app/scene/scene_repeat.h"
#include "sim/base/errors.h"
#include "sim/rig/bodies/make_actor.h"
#include "tests/places.h"
#include "tests/temp_folder.h"

namespace knuckle {
namespace {

Scene load(const std::string& text, const std::vector<Override>& overrides = {})
{
    const test::TempFolder folder;
    return loadScene(folder.write("some_scene.json", text), overrides);
}

const char* const ONE_BOX = R"({ "objects": [{ "type": "rigid", "shape": "box" }] })";

TEST(Scene, NeedsNothingButAnObject)
{
    const Scene scene = load(ONE_BOX);
    EXPECT_EQ(scene.name, "some_scene");
    EXPECT_EQ(scene.world.particles.size(), 27u);
    EXPECT_EQ(scene.frameCount(), 300u);
    EXPECT_EQ(scene.world.settings.substeps, automaticSubsteps(0.1f, 1.0f / 60.0f, SolverKind::Impulse));
    EXPECT_TRUE(scene.render.camera.automatic);
}

TEST(Scene, MayHoldComments)
{
    EXPECT_NO_THROW(load("// first\n{ /* second */ \"objects\": [{ \"type\": \"joined\" }] }"));
}

TEST(Scene, OneWordMakesARigidThingSoft)
{
    for (const char* shape : {R"("box")", R"("sphere")", R"("capsule")", R"("mesh", "file": "FILE")"}) {
        std::string text = R"({ "diameter": 0.08, "objects": [{ "type": "rigid", "spin": [0, 1, 0], "fixed": false,
                               "shape": )" +
                           std::string(shape) + " }] }";
        const size_t file = text.find("FILE");
        if (file != std::string::npos) text.replace(file, 4, test::inSource("assets/models/humanoid.glb"));
        const World rigid = load(text).world, soft = load(text, {{"objects.0.type", "soft"}}).world;
        ASSERT_EQ(soft.particles.size(), rigid.particles.size()) << shape;
        EXPECT_EQ(rigid.softBodies.size(), 0u);
        EXPECT_EQ(soft.bodies.size(), 0u);
        ASSERT_EQ(soft.softBodies.size(), 1u);
        EXPECT_GT(soft.clusters.size(), 0u);
        for (size_t i = 0; i < soft.particles.size(); ++i)
            EXPECT_EQ(soft.particles[i].velocity, rigid.particles[i].velocity) << shape;
    }
}

TEST(Scene, TakesThePapersChoicesExceptWhatItSaysItself)
{
    const Settings paper = load(ONE_BOX, {{"solver", "paper"}}).world.settings;
    EXPECT_EQ(paper.solver, SolverKind::Paper);
    EXPECT_EQ(paper.iterations, paperSettings().iterations);
    EXPECT_EQ(paper.freeze, 0.5f);
    EXPECT_EQ(paper.grid, GridKind::Hash);
    const Settings mixed = load(ONE_BOX, {{"solver", "paper"}, {"solver.iterations", 9}}).world.settings;
    EXPECT_EQ(mixed.iterations, 9u);
    EXPECT_EQ(mixed.rotation, RotationMethod::Householder);
}

TEST(Scene, TakesOverridesBeforeItIsChecked)
{
    const Scene scene = load(
        ONE_BOX, {parseOverride("render.colorBy=speed"), parseOverride("objects.0.size=[1,1,1]"),
                  parseOverride("duration=0.5"), parseOverride("name=other"),
                  parseOverride(R"(colliders.-={"type": "plane"})"), parseOverride("/colliders/0/position=[0,-1,0]")});
    ASSERT_EQ(scene.world.colliders.size(), 1u);
    EXPECT_EQ(scene.world.colliders[0].position.y(), -1.0f);
    EXPECT_EQ(scene.render.colorBy, ColorBy::Speed);
    EXPECT_EQ(scene.world.particles.size(), 1000u);
    EXPECT_EQ(scene.frameCount(), 30u);
    EXPECT_EQ(scene.name, "other");
}

TEST(Scene, HasTheDiameterOfItsActorsUnlessToldOtherwise)
{
    const test::TempFolder folder;
    const auto diameterOf = [&](const std::string& start, const std::string& more) {
        const std::string file = test::inSource("assets/models/humanoid.glb");
        return loadScene(folder.write("scene.json", "{ " + start + R"("objects": [{ "type": "rigid", "shape": "box" },
            { "type": "actor", "file": ")" + file + "\" }" +
                                                        more + "] }"))
            .world.diameter();
    };
    const Actor fine = makeActor(importModel(test::inSource("assets/models/humanoid.glb")), {});
    EXPECT_EQ(diameterOf("", ""), fine.diameter);
    EXPECT_EQ(diameterOf(R"("diameter": 0.08, )", ""), 0.08f);
    ActorOptions finest;
    finest.voxels.diameter = 0.03f;
    writeActor(folder.path("fine.json"), makeActor(importModel(test::inSource("assets/models/dog.glb")), finest));
    EXPECT_EQ(diameterOf("", R"(, { "type": "actor", "file": "fine.json" })"), 0.03f);
    // A crate is a crate at any diameter, so its size does not count.
    EXPECT_EQ(diameterOf("", R"(, { "type": "actor", "scale": 0.1, "file": ")" +
                                 test::inSource("assets/models/crate.glb") + "\" }"),
              fine.diameter);
}

TEST(Scene, StandsStillWithItsCameraWhereItIsTold)
{
    EXPECT_FALSE(load(ONE_BOX, {parseOverride("camera.target=[0,2,0]")}).render.camera.automatic);
    EXPECT_TRUE(load(ONE_BOX, {parseOverride("camera.fieldOfView=30")}).render.camera.automatic);
}

TEST(Scene, FollowsItsFirstObjectUnlessTold)
{
    EXPECT_EQ(load(ONE_BOX, {parseOverride("camera.kind=follow")}).render.camera.follow, "object_1");
}

TEST(Scene, TakesTheStaticFrictionForBothWhereOneIsGiven)
{
    const Scene scene = load(ONE_BOX, {parseOverride("materials.default.staticFriction=0.2")});
    EXPECT_FLOAT_EQ(scene.world.materials[0].kineticFriction, 0.2f);
}

TEST(Scene, PaintsFluidsBlueUnlessTold)
{
    const Scene scene = load(
        R"({ "materials": { "brine": { "fluid": true }, "milk": { "fluid": true, "color": [1, 1, 1] },
                                                 "wood": {} },
                                  "objects": [{ "type": "fluid", "material": "brine", "shape": "box" }] })");
    for (const Material& material : scene.world.materials) {
        const bool blue = material.name == "brine" || material.name == "water";
        EXPECT_EQ(material.color.z() > 2 * material.color.x(), blue) << material.name;
    }
}

TEST(Scene, LeavesOutFluidThatBeginsInColliders)
{
    // Spacing 0.05 m: 20 x 20 x 20 points, of which 8 x 8 x 8 are in the middle 0.4 m.
    const std::string water = R"("objects": [{ "type": "fluid", "shape": "box", "size": [1, 1, 1] }],)";
    const auto box = [&](const char* size) {
        return "{ " + water + R"("fluidSpacing": 0.5, "colliders": [{ "type": "box", "size": )" + size + " }] }";
    };
    EXPECT_EQ(load(box("[0.4, 0.4, 0.4]")).world.fluidCount, 8000u - 512u);
    EXPECT_THROW(load(box("[2, 2, 2]")), InputError);
}

TEST(FrameSteps, AreAsNearToTheTimeStepAsCanBe)
{
    const double step = 1.0 / 60.0;
    EXPECT_EQ(stepsForFrame(60, step), 1u);
    EXPECT_EQ(stepsForFrame(30, step), 2u);
    EXPECT_EQ(stepsForFrame(24, step), 3u);  // 1/72 is 0.0028 away, 1/48 is 0.0042
    EXPECT_EQ(stepsForFrame(240, step), 1u);
    EXPECT_EQ(stepsForFrame(60, SHORTEST_TIME_STEP), 166u);  // of 167 each would be shorter than may be
    const Scene scene = load(ONE_BOX, {parseOverride("fps=24")});
    EXPECT_FLOAT_EQ(scene.world.settings.timeStep, 1.0f / 72.0f);
}

TEST(Repetition, MakesEveryCopyOfTheGrid)
{
    const Scene scene = load(R"({ "objects": [{ "type": "rigid", "shape": "box", "name": "cube", "position": [1, 2, 3],
        "repeat": { "counts": [3, 2, 4], "spacing": [1, 2, 1] } }] })");
    ASSERT_EQ(scene.world.objects.size(), 24u);
    EXPECT_EQ(scene.world.particles.size(), 24u * 27u);
    EXPECT_EQ(scene.world.objects.front().name, "cube_1");
    EXPECT_EQ(scene.world.objects.back().name, "cube_24");
    Vector3f low = Vector3f::Constant(1e9f), high = -low;
    for (const Particle& particle : scene.world.particles) {
        low = low.cwiseMin(particle.position);
        high = high.cwiseMax(particle.position);
    }
    // Centred in x and z, upwards from the position in y; a cube reaches one diameter, 0.1 m, about its centre.
    EXPECT_LT((low - Vector3f(-0.1f, 1.9f, 1.4f)).norm(), 1e-5f);
    EXPECT_LT((high - Vector3f(2.1f, 4.1f, 4.6f)).norm(), 1e-5f);
}

TEST(Repetition, GivesEachJointTypeItsShare)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined", "joints": ["ball", "hinge", "stiff", "universal"],
        "repeat": { "counts": [5, 1, 8], "spacing": [2, 2, 2] } }] })");
    EXPECT_EQ(jointCount(scene.world), 40u);
    // A universal joint is two hinges.
    for (const auto& [type, count] :
         {std::pair{JointType::Ball, 10}, std::pair{JointType::Hinge, 30}, std::pair{JointType::Stiff, 10}})
        EXPECT_EQ(std::ranges::count(scene.world.joints, type, &Joint::type), count);
}

TEST(Repetition, IsTheSameForTheSameSeed)
{
    const auto positions = [](int seed) {
        const Scene scene = load(R"({ "objects": [{ "type": "rigid", "shape": "box", "repeat": { "counts": [2, 2, 2],
            "jitter": 0.3, "randomRotation": true } }] })",
                                 {{"objects.0.repeat.seed", seed}});
        std::vector<float> all;
        for (const Particle& particle : scene.world.particles) {
            all.insert(all.end(), particle.position.begin(), particle.position.end());
        }
        return all;
    };
    EXPECT_EQ(positions(3), positions(3));
    EXPECT_NE(positions(3), positions(4));
}

TEST(Repetition, MovesNoCopyByMoreThanTheJitter)
{
    Json object = Json::parse(R"({ "position": [0, 0, 0], "rotation": [0, 0, 0], "repeat": { "counts": [500, 1, 1],
        "spacing": [0, 0, 0], "jitter": 0.25, "randomRotation": true, "seed": 5 } })");
    Vector3f mean = Vector3f::Zero();
    for (const Pose& pose : repeatedPoses(object)) {
        EXPECT_LE(pose.translation.cwiseAbs().maxCoeff(), 0.25f);
        EXPECT_NEAR(pose.rotation.norm(), 1.0f, 1e-5f);
        mean += pose.translation / 500.0f;
    }
    // The mean of 500 uniform numbers in +-0.25 has a standard deviation of 0.25 / sqrt(3 * 500) = 0.0065.
    EXPECT_LT(mean.cwiseAbs().maxCoeff(), 5.0f * 0.0065f);
}

TEST(Chain, HoldsTheEndThatItIsTold)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined", "bodies": 5, "hold": "last" }] })");
    ASSERT_EQ(scene.world.bodies.size(), 5u);
    EXPECT_EQ(scene.world.bodies.front().motion, Motion::Dynamic);
    EXPECT_EQ(scene.world.bodies.back().motion, Motion::Fixed);
    EXPECT_EQ(scene.world.particles.size(), 5u * 27u + 4u);
}

TEST(Chain, LeavesALayerForTheJointsParticles)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined" }] })");
    const Vector3f distance = scene.world.bodies[1].restCentre - scene.world.bodies[0].restCentre;
    // Four diameters from box to box, less the shift of both centres of mass by the shared particle in between: half
    // its mass in each, 0.5 / 27.5 of 0.2 m on each side.
    EXPECT_NEAR(distance.norm(), 0.4f - 2.0f * 0.2f * 0.5f / 27.5f, 1e-4f);
}

TEST(Chain, MayLeaveMoreRoomAtItsJoints)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined", "joints": ["universal"], "gap": 2 }] })");
    float left = -1e9f, right = 1e9f;
    for (const Particle& particle : scene.world.particles) {
        if (particle.bodyCount > 1 || std::abs(particle.position.x()) < 0.01f) continue;
        if (particle.position.x() < 0.0f) left = std::max(left, particle.position.x());
        if (particle.position.x() > 0.0f) right = std::min(right, particle.position.x());
    }
    EXPECT_NEAR(right - left, 0.3f, 1e-5f);  // two layers of 0.1 m between the two faces' centres
}

TEST(Colliders, OfAContainerAreAFloorAndFourWalls)
{
    const char* text = R"({ "objects": [{ "type": "joined" }],
                            "colliders": [{ "type": "container", "width": 4, "depth": 2, "height": 0 }] })";
    const Scene planes = load(text);
    ASSERT_EQ(planes.world.colliders.size(), 5u);
    for (const Collider& wall : planes.world.colliders) {
        EXPECT_EQ(wall.shape, ColliderShape::Plane);
        // The middle of the box, one metre up, is on the free side of all walls.
        const Vector3f normal = wall.orientation * Vector3f::UnitY();
        EXPECT_GT(normal.dot(Vector3f(0, 1, 0) - wall.position), 0.9f);
    }
    const Scene boxes = load(text, {{"colliders.0.height", 1}});
    ASSERT_EQ(boxes.world.colliders.size(), 5u);
    EXPECT_EQ(boxes.world.colliders[1].shape, ColliderShape::Box);
    EXPECT_NEAR(boxes.world.colliders[1].position.x() + boxes.world.colliders[1].halfExtents.x(), -2.0f, 1e-5f);
}

TEST(Colliders, OfStairsClimbTowardsMinusZ)
{
    const Scene scene = load(R"({ "objects": [{ "type": "joined" }],
        "colliders": [{ "type": "stairs", "steps": 4, "rise": 0.2, "run": 0.3 }] })");
    ASSERT_EQ(scene.world.colliders.size(), 4u);
    for (size_t i = 0; i < 4; ++i) {
        const Collider& step = scene.world.colliders[i];
        const auto n = static_cast<float>(i);
        EXPECT_NEAR(step.position.y() + step.halfExtents.y(), 0.2f * (n + 1.0f), 1e-5f);
        EXPECT_NEAR(step.position.z() + step.halfExtents.z(), -0.3f * n, 1e-5f);
    }
}

TEST(Colliders, TurnAboutXThenYThenZ)
{
    const Json json{{"rotation", {90, 90, 0}}};
    // First about x: +z goes to -y, which the turn about y does not change.
    EXPECT_LT((readRotation(json) * Vector3f::UnitZ() - Vector3f(0, -1, 0)).norm(), 1e-5f);
}

TEST(SceneFolder, HoldsOnlyScenesThatCanBeRead)
{
    for (const auto& entry : std::filesystem::directory_iterator(test::inSource("assets/scenes"))) {
        EXPECT_NO_THROW(loadScene(entry.path().string())) << entry.path();
        const std::string text = test::readText(entry.path().string());
        EXPECT_TRUE(text.starts_with("// ")) << entry.path() << ": the first line describes the scene";
        EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 40) << entry.path();
    }
}

}  // namespace
}  // namespace knuckle
