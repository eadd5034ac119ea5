#include "sim/rig/anatomy/facing.h"

#include "sim/rig/clips/body_clip.h"
#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

/// The figure with left and right exchanged in names.
BoxBones swapped(BoxBones bones)
{
    for (BoxBone& bone : bones) {
        for (std::string* name : {&bone.name, &bone.parent}) {
            if (name->ends_with(".L")) name->back() = 'R';
            else if (name->ends_with(".R")) name->back() = 'L';
        }
    }
    return bones;
}

/// The figure without feet, or with feet as long behind the ankle as before it.
BoxBones withoutToes(BoxBones bones)
{
    for (BoxBone& bone : bones)
        if (bone.name.starts_with("foot")) bone.centre.z() = bone.head.z();
    return bones;
}

/// Turned to face -z, as a figure in a file may.
BoxBones turnedRound(BoxBones bones)
{
    for (BoxBone& bone : bones)
        for (Vector3f* place : {&bone.head, &bone.centre}) *place = place->cwiseProduct(Vector3f(-1, 1, -1));
    return bones;
}

Vector3f kneeAxis(const Actor& actor)
{
    Vector3f left = jointOf(actor, "shin.L").axis;
    const Vector3f right = jointOf(actor, "shin.R").axis;
    EXPECT_GT(left.dot(right), 0.99f);
    return left;
}

bool hasNote(const Actor& actor, const std::string& text)
{
    return std::ranges::any_of(actor.notes, [&](const std::string& note) { return note.find(text) != note.npos; });
}

TEST(Facing, KneesFoldAwayFromTheToesWhateverSidesAreCalled)
{
    const Actor named = make(boxFigure(boxPerson()), 0.04f), viewed = make(boxFigure(swapped(boxPerson())), 0.04f),
                turned = make(boxFigure(turnedRound(boxPerson())), 0.04f);
    EXPECT_GT(kneeAxis(named).x(), 0.99f);
    EXPECT_GT(kneeAxis(viewed).x(), 0.99f);
    EXPECT_LT(kneeAxis(turned).x(), -0.99f);
    EXPECT_FALSE(hasNote(named, "looks"));
    EXPECT_FALSE(hasNote(turned, "looks"));
    EXPECT_TRUE(hasNote(viewed, "The figure looks where toes say, not where names of sides do")) << viewed.notes.back();
}

TEST(Facing, HipsLeanOutwardsToTheSideOnWhichTheyAre)
{
    const Actor actor = make(boxFigure(swapped(boxPerson())), 0.04f);
    EXPECT_LT(jointOf(actor, "thigh.L").limits.cone.x(), 0.0f);  // which is at -x
    EXPECT_GT(jointOf(actor, "thigh.R").limits.cone.x(), 0.0f);
    EXPECT_GT(jointOf(actor, "thigh.L").limits.cone.z(), 0.0f);
}

TEST(Facing, WithoutOtherSignsNamesSayIt)
{
    EXPECT_LT(kneeAxis(make(boxFigure(withoutToes(swapped(boxPerson()))), 0.04f)).x(), -0.99f);
    // The toes of a figure alone do not outweigh names that a face and knees confirm.
    BoxBones bones = boxPerson();
    for (BoxBone& bone : bones)
        if (bone.name.starts_with("foot")) bone.centre.z() = -bone.centre.z();
    bones.push_back({"eye.L", "head", {0.03f, 1.6f, 0.1f}, {0.03f, 1.6f, 0.1f}, {0.01f, 0.01f, 0.01f}});
    bones.push_back({"nose", "head", {0, 1.57f, 0.12f}, {0, 1.57f, 0.12f}, {0.01f, 0.01f, 0.01f}});
    const Actor actor = make(boxFigure(bones), 0.04f);
    EXPECT_GT(kneeAxis(actor).x(), 0.99f);
    EXPECT_TRUE(hasNote(actor, "The figure looks where names of sides, face say, not where toes do"));
}

TEST(Facing, AFaceOrBentLimbsSayItToo)
{
    BoxBones face = withoutToes(swapped(boxPerson()));
    face.push_back({"Jaw", "head", {0, 1.5f, 0.08f}, {0, 1.5f, 0.1f}, {0.03f, 0.02f, 0.02f}});
    EXPECT_GT(kneeAxis(make(boxFigure(face), 0.04f)).x(), 0.99f);
    BoxBones bent = withoutToes(swapped(boxPerson()));
    for (BoxBone& bone : bent) {
        if (bone.name.starts_with("shin"))
            for (Vector3f* place : {&bone.head, &bone.centre}) place->z() += 0.08f;
        if (bone.name.starts_with("forearm"))
            for (Vector3f* place : {&bone.head, &bone.centre}) place->z() -= 0.05f;
        if (bone.name.starts_with("forearm")) bone.centre.z() += 0.02f;
    }
    const std::vector<BoneAnatomy> anatomy = readAnatomy(boxFigure(bent));
    EXPECT_LT(readFacing(boxFigure(bent), anatomy).against, 1.3f);
}

TEST(Facing, ACreaturesHeadIsInFront)
{
    const Model dog = boxFigure(swapped(boxDog()));
    const Actor actor = make(dog, 0.04f);
    EXPECT_LT(jointOf(actor, "FrontLowLeg.L").axis.x(), -0.9f);  // elbows forward
    EXPECT_TRUE(hasNote(actor, "names of sides"));
    EXPECT_EQ(readAnatomy(dog)[indexOf(dog, "BackLeg.L")].side, -1);
}

/// The legs of a figure as of a squat, in a clip of one second.
Model squatting(Model model)
{
    Clip clip;
    clip.name = "squat";
    for (const float bend : {0.0f, 1.2f, 0.0f}) {
        std::vector<Eigen::Matrix4f> poses;
        for (const Bone& bone : model.bones) poses.push_back(bone.restPose);
        for (const char* side : {".L", ".R"}) {
            const auto turnAt = [&](const std::string& name, const Vector3f& head, float angle) {
                Eigen::Matrix4f& pose = poses[indexOf(model, name + side)];
                pose.topLeftCorner<3, 3>() = Eigen::AngleAxisf(angle, Vector3f::UnitX()).toRotationMatrix();
                pose.block<3, 1>(0, 3) = head;
            };
            const auto at = [&](const std::string& name) { return boneHead(model, indexOf(model, name + side)); };
            const Vector3f thigh = at("thigh"), upper = at("shin") - thigh, lower = at("foot") - at("shin");
            const Vector3f knee = thigh + Eigen::AngleAxisf(-bend, Vector3f::UnitX()) * upper;
            turnAt("thigh", thigh, -bend);
            turnAt("shin", knee, bend);
            turnAt("foot", knee + Eigen::AngleAxisf(bend, Vector3f::UnitX()) * lower, 0);
        }
        clip.keyTimes.push_back(0.5 * static_cast<double>(clip.keyTimes.size()));
        clip.poses.push_back(poses);
    }
    clip.duration = 1.0;
    model.clips.push_back(clip);
    return model;
}

TEST(Facing, KneesThatClipsBendSayIt)
{
    const Model model = squatting(boxFigure(withoutToes(swapped(boxPerson()))));
    EXPECT_EQ(readAnatomy(model)[indexOf(model, "thigh.L")].side, -1);
    EXPECT_LT(jointOf(make(model, 0.04f), "thigh.L").limits.cone.x(), 0.0f);
}

TEST(Facing, AClipOfAnotherSkeletonTurnsAFigureTheWayItLooks)
{
    // The actor's names give sides as a viewer sees them, those of the clip's file do not, or use other words.
    const Actor actor = make(boxFigure(swapped(boxPerson())), 0.04f);
    Model source = squatting(boxFigure(boxPerson()));
    for (Bone& bone : source.bones) bone.name = "x:" + bone.name;
    for (const bool otherNames : {false, true}) {
        for (Bone& bone : source.bones)
            if (otherNames && bone.name.find("thigh") != std::string::npos) bone.name.replace(2, 5, "UpLeg");
        const BodyClip clip = foreignClip(actor, readFigure(source), source.clips.front()).clip;
        const auto thigh = std::ranges::find(actor.bodies, "thigh.L", &ActorBody::name) - actor.bodies.begin();
        const Quaternionf turn = turnsOf(clip, static_cast<uint32_t>(thigh))[1];
        EXPECT_GT((turn * Vector3f(0, -1, 0)).z(), 0.5f) << "a squat brings knees forward";
    }
}

}  // namespace
}  // namespace knuckle::test
