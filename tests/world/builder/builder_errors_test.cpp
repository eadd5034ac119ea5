#include <limits>

#include "tests/world/world_fixture.h"

namespace knuckle::test {

namespace {

constexpr float INFINITE = std::numeric_limits<float>::infinity();

}  // namespace

TEST(BuilderErrors, AParticleRadiusThatIsNotAboveZeroIsRefused)
{
    EXPECT_EQ(misuseOf([] { WorldBuilder builder(0.0f); }), "particle radius 0 m: must be above 0");
    EXPECT_EQ(misuseOf([] { WorldBuilder builder(-0.5f); }), "particle radius -0.5 m: must be above 0");
    EXPECT_EQ(misuseOf([] { WorldBuilder builder(NAN); }), "particle radius nan m: must be above 0");
    EXPECT_EQ(misuseOf([] { WorldBuilder builder(INFINITE); }), "particle radius inf m: must be above 0");
}

TEST(BuilderErrors, CallsOutsideAnObjectAreRefused)
{
    WorldBuilder builder = makeBuilder();
    EXPECT_EQ(misuseOf([&] { builder.addBody("a", cubeAt({0, 0, 0}), 0); }), "addBody: call beginObject() first");
    EXPECT_EQ(misuseOf([&] { builder.addJoint(0, 1, {}); }), "addJoint: call beginObject() first");
    EXPECT_EQ(misuseOf([&] { builder.setSelfMargin(0.5f); }), "setSelfMargin: call beginObject() first");
    EXPECT_EQ(misuseOf([&] { builder.describeJoint({}); }), "describeJoint: call beginObject() first");
    EXPECT_EQ(misuseOf([&] { builder.endObject(); }), "endObject: call beginObject() first");
}

TEST(BuilderErrors, ObjectsDoNotNestAndMustBeClosed)
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("outer");
    EXPECT_EQ(misuseOf([&] { builder.beginObject("inner"); }), "object \"inner\": the one before is still open");
    builder.addBody("a", cubeAt({0, 0, 0}), 0);
    EXPECT_EQ(misuseOf([&] { builder.build(); }), "build(): the last object is still open");
}

TEST(BuilderErrors, ABodyNeedsAMaterialAndFiniteParticles)
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("object");
    EXPECT_EQ(misuseOf([&] {
                  builder.addBody("head", cubeAt({0, 0, 0}), 7);
              }),
              "body \"head\": there is no material 7");
    EXPECT_EQ(misuseOf([&] { builder.addBody("head", {}, 0); }), "body \"head\" has no particles");
    for (float bad : {NAN, INFINITE})
        EXPECT_EQ(misuseOf([&] {
                      builder.addBody("head", std::vector<Vector3f>{{0, bad, 0}}, 0);
                  }),
                  "body \"head\": a particle's position is not finite");
}

TEST(BuilderErrors, AJointNeedsTwoDifferentBodiesThatExist)
{
    WorldBuilder builder = makeBuilder();
    builder.beginObject("object");
    builder.addBody("a", cubeAt({-2, 0, 0}), 0);
    builder.addBody("b", cubeAt({2, 0, 0}), 0);
    JointSpec spec;
    spec.name = "knee";
    const std::string wanted = "joint \"knee\": needs two different bodies that exist";
    EXPECT_EQ(misuseOf([&] { builder.addJoint(0, 0, spec); }), wanted);
    EXPECT_EQ(misuseOf([&] { builder.addJoint(0, 2, spec); }), wanted);
    EXPECT_EQ(misuseOf([&] { builder.addJoint(9, 1, spec); }), wanted);
}

TEST(BuilderErrors, AWorldWithoutParticlesIsRefused)
{
    EXPECT_EQ(complaintOf([] { makeBuilder().build(); }), "the world has no particles: add an object");
}

TEST(BuilderErrors, BuildValidates)
{
    Settings settings;
    settings.substeps = 65;
    EXPECT_EQ(misuseOf([&] { jointedCubes({}, settings); }), "solver substeps 65: must be 1 to 64");
}

}  // namespace knuckle::test
