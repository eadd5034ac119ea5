#include "sim/rig/bodies/make_actor.h"
#include "sim/world/builder/builder.h"
#include "tests/rig/actor_fixture.h"
#include "tests/rig/figures/box_figure.h"

namespace knuckle::test {
namespace {

/// Arms that droop by an angle, and point as far to the front [rad].
Model drooping(float down, float ahead)
{
    BoxBones bones = boxPerson();
    for (BoxBone& bone : bones) {
        if (bone.name.find("forearm") == std::string::npos && bone.name.find("upper_arm") == std::string::npos)
            continue;
        for (Vector3f* place : {&bone.head, &bone.centre}) {
            const float out = std::abs(place->x()) - 0.18f;
            *place += Vector3f(0, -down * out, ahead * out);
        }
    }
    return boxFigure(bones);
}

void expectBuilds(const Model& model)
{
    const Actor actor = make(model, 0.05f);
    WorldBuilder builder(0.5f * actor.diameter);
    addActor(builder, actor, builder.addMaterial({}), {});
    const World world = builder.build();
    for (const Joint& joint : world.joints)
        for (const JointSide* side : {&joint.parentSide, &joint.childSide})
            EXPECT_NEAR(side->frame.norm(), 1.0f, 1e-5f) << joint.name;
}

TEST(DroopingArms, HaveFramesAtEveryAngle)
{
    for (const float angle :
         {0.0f, 1e-8f, 1e-7f, 1e-6f, 1e-5f, 1e-4f, 1e-3f, 3e-3f, 4.5e-3f, 5e-3f, 5.5e-3f, 6e-3f, 1e-2f, 3e-2f, 0.1f}) {
        expectBuilds(drooping(angle, 0));
        expectBuilds(drooping(-angle, angle));
        expectBuilds(drooping(0, -angle));
    }
}

}  // namespace
}  // namespace knuckle::test
