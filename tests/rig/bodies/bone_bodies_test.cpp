#include "sim/base/errors.h"
#include "tests/message_of.h"
#include "tests/rig/actor_fixture.h"

namespace knuckle {
namespace {

TEST(BodiesOfBones, boneTooSmallForABodyMergesIntoItsParentAndIsNoted)
{
    Model model = twoBoneBox("tip", 0.02f);  // a rod: one row of particles, all on one line
    model.bones.push_back({"root2", -1});
    Model body = twoBoneBox("unused");
    for (size_t v = 0; v < 8; ++v) {  // a solid root so that there is a body at all
        model.vertices.push_back(body.vertices[v] + Vector3f(0, 0, -1));
        model.skin.push_back(body.skin[v]);
    }
    for (size_t t = 0; t < 12; ++t) {
        const auto& triangle = body.triangles[t];
        model.triangles.push_back({triangle[0] + 16, triangle[1] + 16, triangle[2] + 16});
    }
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 1u);
    EXPECT_EQ(actor.bodies[0].mergedBones, std::vector<std::string>{"tip"});
    EXPECT_TRUE(std::any_of(actor.notes.begin(), actor.notes.end(),
                            [](const std::string& note) { return note.find("tip") != std::string::npos; }));
}

TEST(BodiesOfBones, smallBoneMergesIntoItsParentEvenWhereAnotherBodyIsNearer)
{
    Model model = twoBoneBox("other");
    const TriangleMesh rod = boxMesh({0, 0, 2.4f}, {0.02f, 0.02f, 0.2f});
    for (const Triangle& t : rod.triangles) {
        model.triangles.push_back({t[0] + 16, t[1] + 16, t[2] + 16});
    }
    for (const Vector3f& v : rod.vertices) {
        model.vertices.push_back(v);
        model.skin.push_back({{2}, {1.0f}});
    }
    model.bones.push_back({"rod", 0});
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 2u);
    EXPECT_EQ(actor.bodies[0].name, "root");
    EXPECT_EQ(actor.bodies[0].mergedBones, std::vector<std::string>{"rod"});
}

TEST(BodiesOfBones, partsThatDoNotTouchAreBridgedAtTheJoint)
{
    Model model = twoBoneBox("tip");
    for (size_t v = 8; v < 16; ++v) {
        model.vertices[v].z() += 0.4f;  // four diameters of air
    }
    model.bones[1].restPose(2, 3) = 1.2f;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

TEST(BodiesOfBones, secondRootJoinsTheNearestBody)
{
    Model model = twoBoneBox("tip");
    model.bones[1].parent = -1;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

/// Boxes of 0.5 m, each of a bone whose head is where the box begins.
struct Boxes {
    Model model;

    uint32_t add(const std::string& name, int32_t parent, const Vector3f& middle, bool hasBox = true)
    {
        const auto index = static_cast<uint32_t>(model.bones.size()), first = uint32_t(model.vertices.size());
        Bone bone{name, parent};
        bone.restPose.block<3, 1>(0, 3) = middle - Vector3f(0, 0, 0.25f);
        model.bones.push_back(bone);
        const TriangleMesh box = boxMesh(middle, Vector3f::Constant(0.25f));
        for (size_t v = 0; hasBox && v < box.vertices.size(); ++v) {
            model.vertices.push_back(box.vertices[v]);
            model.skin.push_back({{index}, {1.0f}});
        }
        for (size_t t = 0; hasBox && t < box.triangles.size(); ++t) {
            const Triangle& triangle = box.triangles[t];
            model.triangles.push_back({triangle[0] + first, triangle[1] + first, triangle[2] + first});
        }
        return index;
    }
};

std::string parentName(const Actor& actor, const std::string& body)
{
    const auto found = std::ranges::find(actor.bodies, body, &ActorBody::name);
    if (found == actor.bodies.end() || found->parent < 0) return "none";
    return actor.bodies[found->parent].name;
}

TEST(BodiesOfBones, aSecondRootJoinsItsSiblingInTheSkeletonNotWhatIsNear)
{
    Boxes boxes;
    boxes.add("scene", -1, {0, 0, 0}, false);
    const uint32_t base = boxes.add("base", 0, {0, 0, 0});
    boxes.add("crane", int32_t(base), {0, 0, 0.5f});
    boxes.add("load", 0, {0, 0.55f, 0.6f});  // beside the crane, and two bones from the base
    const Actor actor = make(boxes.model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(parentName(actor, "load"), "base");
}

TEST(BodiesOfBones, aBodyApartFromItsParentStaysItsChild)
{
    Boxes boxes;
    boxes.add("base", -1, {0, 0, 0});
    boxes.add("crane", 0, {0, 0, 0.5f});
    boxes.add("load", 0, {0, 0, 1.0f});
    EXPECT_EQ(parentName(make(boxes.model, 0.1f), "load"), "base");
}

TEST(BodiesOfBones, aFootThatHangsOnAControlJoinsItsShin)
{
    Boxes boxes;
    boxes.add("root", -1, {0, 0, 0}, false);
    boxes.add("Hips", 0, {0, 0, 0});
    boxes.add("UpperLeg.L", 1, {0, 0, 0.5f});
    boxes.add("LowerLeg.L", 2, {0, 0, 1.0f});
    boxes.add("Foot.L", 0, {0, 0.45f, 0.5f});  // beside the thigh
    const Actor actor = make(boxes.model, 0.1f);
    EXPECT_EQ(parentName(actor, "Foot.L"), "LowerLeg.L");
    EXPECT_TRUE(
        std::ranges::count(actor.notes, "Foot.L is joined to LowerLeg.L, which its part of a body belongs to."));
}

TEST(BodiesOfBones, twistsAndPropsArePartsOfTheirLimb)
{
    Boxes boxes;
    boxes.add("Hips", -1, {0, 0, 0});
    boxes.add("thigh.L", 0, {0, 0, 0.5f});
    boxes.add("thigh.L.001", 1, {0, 0, 1.0f});
    boxes.add("shin.L", 2, {0, 0, 1.5f});
    boxes.add("holster", 1, {0, 0.5f, 0.5f});
    const Actor actor = make(boxes.model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 3u);
    EXPECT_EQ(actor.bodies[1].mergedBones, (std::vector<std::string>{"thigh.L.001", "holster"}));
    EXPECT_EQ(parentName(actor, "shin.L"), "thigh.L");
    EXPECT_TRUE(std::ranges::count(actor.notes, "thigh.L took in thigh.L.001, of the same limb."));
    EXPECT_TRUE(std::ranges::count(actor.notes, "thigh.L took in holster, attached to it."));
}

TEST(BodiesOfBones, patternsKeepAndMerge)
{
    Boxes boxes;
    boxes.add("base", -1, {0, 0, 0});
    boxes.add("hair_01", 0, {0, 0, 0.5f});
    boxes.add("hair_02", 1, {0, 0, 1.0f});
    boxes.add("hook", 0, {0, 0.5f, 0});
    EXPECT_EQ(make(boxes.model, 0.1f).bodies.size(), 2u);
    ArticulationOptions options;
    options.keep = {"hair_*"};
    EXPECT_EQ(make(boxes.model, 0.1f, options).bodies.size(), 4u);
    options.merge = {"hair_02", "h??k"};
    const Actor actor = make(boxes.model, 0.1f, options);
    ASSERT_EQ(actor.bodies.size(), 2u);
    EXPECT_EQ(actor.bodies[0].mergedBones, std::vector<std::string>{"hook"});
    EXPECT_EQ(actor.bodies[1].mergedBones, std::vector<std::string>{"hair_02"});
    options.merge = {"wing*"};
    EXPECT_EQ(test::messageOf<InputError>([&] { make(boxes.model, 0.1f, options); }),
              "bone to merge 'wing*': the model '' has no bone of that name");
}

TEST(BodiesOfBones, modelWithoutBonesIsOneRigidBody)
{
    Model model;
    model.name = "ball";
    const TriangleMesh mesh = sphereMesh(0.5f);
    model.vertices = mesh.vertices;
    model.triangles = mesh.triangles;
    const Actor actor = make(model, 0.1f);
    ASSERT_EQ(actor.bodies.size(), 1u);
    EXPECT_EQ(actor.bodies[0].name, "ball");
    EXPECT_EQ(actor.bodies[0].particles.size(), actor.particles.size());
    EXPECT_TRUE(actor.joints.empty());
}

bool hasNote(const Actor& actor, const std::string& text)
{
    return std::ranges::any_of(actor.notes, [&](const std::string& note) { return note.find(text) != note.npos; });
}

TEST(BodiesOfBones, aLimbWithoutSkinIsNotSaidToBeTooSmall)
{
    Model model = twoBoneBox("tip");
    for (const char* name : {"thigh.L", "shin.L", "foot.L"}) {
        const auto parent = static_cast<int32_t>(model.bones.size() - 1);
        model.bones.push_back({name, parent, model.bones.back().restPose});
        model.bones.back().restPose(1, 3) -= 0.1f;
    }
    EXPECT_FALSE(hasNote(make(model, 0.1f), "--diameter"));
    model.skin[9] = {{1, 2}, {0.9f, 0.1f}};
    EXPECT_TRUE(hasNote(make(model, 0.1f), "--diameter"));
}

TEST(BodiesOfBones, whereNothingTellsWhichBonesAreLimbsTheRemedyIsNamed)
{
    Model model = twoBoneBox("tip");
    const TriangleMesh box = boxMesh({0, 0, 0}, {0.2f, 0.2f, 0.2f});
    for (int arm = 0; arm < 5; ++arm) {
        const Vector3f middle(0.8f * static_cast<float>(arm - 2), 0.6f + 0.1f * static_cast<float>(arm), 0.5f);
        const auto first = static_cast<uint32_t>(model.vertices.size());
        for (const Triangle& t : box.triangles) model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        for (const Vector3f& v : box.vertices) {
            model.vertices.push_back(v + middle);
            model.skin.push_back({{static_cast<uint32_t>(model.bones.size())}, {1.0f}});
        }
        Bone bone{"x" + std::to_string(arm), 0};
        bone.restPose.block<3, 1>(0, 3) = middle;
        model.bones.push_back(bone);
    }
    const Actor actor = make(model, 0.1f);
    EXPECT_TRUE(hasNote(actor, "--joints"));
    EXPECT_FALSE(hasNote(actor, "--up z"));
    for (Vector3f& vertex : model.vertices) vertex.y() *= 0.5f;
    for (Bone& bone : model.bones) bone.restPose(1, 3) *= 0.5f;
    EXPECT_TRUE(hasNote(make(model, 0.1f), "--up z"));
    model.bones.back().name = "tail";
    EXPECT_FALSE(hasNote(make(model, 0.1f), "--joints"));
    EXPECT_FALSE(hasNote(make(twoBoneBox("tip"), 0.1f), "--joints"));
}

}  // namespace
}  // namespace knuckle
