#include "sim/base/errors.h"
#include "sim/rig/import/import.h"
#include "sim/rig/skin/body_plan.h"
#include "tests/places.h"
#include "tests/rig/actor_fixture.h"

namespace knuckle {
namespace {

Actor ofLevel(const Model& model, uint32_t particles, const BodyPlan& plan = {})
{
    ActorOptions options;
    options.particleCount = particles;
    options.plan = plan;
    return makeActor(model, options);
}

TEST(Levels, HaveTheBodiesAndJointsOfTheCoarsest)
{
    for (const char* name : {"humanoid", "dog", "spider"}) {
        const Model model = importModel(test::inSource(std::string("assets/models/") + name + ".glb"));
        const Actor coarse = ofLevel(model, 300), fine = ofLevel(model, 1500, planOf(coarse, model));
        EXPECT_NEAR(static_cast<double>(fine.particles.size()), 1500.0, 75.0) << name;
        EXPECT_EQ(differenceOf(coarse, fine), "") << name;
        ASSERT_EQ(fine.bodies.size(), coarse.bodies.size());
        for (size_t b = 0; b < fine.bodies.size(); ++b)
            EXPECT_EQ(fine.bodies[b].mergedBones, coarse.bodies[b].mergedBones) << name;
        expectSound(fine);
    }
}

TEST(Levels, NeedRoomAtTheirOwnNumberOfParticlesOnly)
{
    // Where the search begins, hands and feet have none.
    const Model model = importModel(test::inSource("assets/models/humanoid.glb"));
    const Actor fine = ofLevel(model, 6000), other = ofLevel(model, 5000, planOf(fine, model));
    EXPECT_NEAR(static_cast<double>(other.particles.size()), 5000.0, 250.0);
    EXPECT_EQ(differenceOf(fine, other), "");
}

TEST(Levels, DifferWithoutAPlan)
{
    const Model model = importModel(test::inSource("assets/models/humanoid.glb"));
    EXPECT_EQ(differenceOf(ofLevel(model, 300), ofLevel(model, 1500)),
              "it has 18 bodies and 17 joints instead of 13 and 12");
}

TEST(Levels, OfPartsHaveThoseOfTheCoarsest)
{
    // A cube of 0.4 m is too small for a body of particles of 0.2 m: it goes with the large one.
    Model model;
    model.name = "crates";
    model.isSplit = true;
    for (const float size : {1.0f, 0.2f}) {
        const uint32_t part = static_cast<uint32_t>(model.bones.size()), first = 8 * part;
        const TriangleMesh mesh = boxMesh({3.0f * static_cast<float>(part), 0, 0}, {size, size, size});
        for (const Triangle& t : mesh.triangles) model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        for (const Vector3f& vertex : mesh.vertices) {
            model.vertices.push_back(vertex);
            SkinWeights& skin = model.skin.emplace_back();
            skin.bones[0] = part;
            skin.weights[0] = 1.0f;
        }
        model.bones.push_back({part == 0 ? "large" : "small", -1});
    }
    const Actor coarse = make(model, 0.2f);
    ASSERT_EQ(coarse.bodies.size(), 1u);
    EXPECT_EQ(make(model, 0.1f).bodies.size(), 2u);
    ActorOptions options;
    options.voxels.diameter = 0.1f;
    options.plan = planOf(coarse, model);
    const Actor fine = makeActor(model, options);
    ASSERT_EQ(fine.bodies.size(), 1u);
    EXPECT_EQ(fine.bodies[0].mergedBones, (std::vector<std::string>{"small"}));
    EXPECT_EQ(fine.bodies[0].particles.size(), fine.particles.size());
}

TEST(Levels, TellWhichBodyHasNoRoom)
{
    const Model model = twoBoneBox("top");
    const BodyPlan plan = planOf(make(model, 0.1f), model);
    ActorOptions options;
    options.voxels.diameter = 0.5f;
    options.plan = plan;
    try {
        makeActor(model, options);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()),
                  "box: particles of 0.5 m are too few for the body root, which the coarsest level has; add a coarser "
                  "level, or leave this one out");
    }
}

}  // namespace
}  // namespace knuckle
