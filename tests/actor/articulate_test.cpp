#include "sim/actor/articulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "sim/actor/humanoid.h"
#include "sim/world/errors.h"
#include "tests/actor/shapes.h"

namespace knuckle {
namespace {

// A box from z = 0 to 2 whose lower half follows one bone and whose upper half another.
Model twoBoneBox(const std::string& upperName, float thickness = 0.25f)
{
    Model model;
    model.name = "box";
    for (int half = 0; half < 2; ++half) {
        const auto h = static_cast<float>(half);
        const TriangleMesh mesh = boxMesh({0, 0, 0.5f + h}, {thickness, thickness, 0.5f});
        for (const Triangle& t : mesh.triangles) {
            const auto first = static_cast<uint32_t>(8 * half);
            model.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        for (const Vector3f& v : mesh.vertices) {
            SkinWeights skin;
            skin.bones[0] = static_cast<uint32_t>(half);
            skin.weights[0] = 1.0f;
            model.vertices.push_back(v);
            model.skin.push_back(skin);
        }
        Bone bone{half == 0 ? "root" : upperName, half - 1};
        bone.restPose(2, 3) = h;
        model.bones.push_back(bone);
    }
    return model;
}

Actor make(const Model& model, float diameter, const ArticulationOptions& articulation = {})
{
    return makeActor(model, {.name = {}, .voxels = {.diameter = diameter}, .articulation = articulation});
}

bool contains(const std::vector<uint32_t>& list, uint32_t value)
{
    return std::find(list.begin(), list.end(), value) != list.end();
}

// What every actor must be: a tree of bodies, joined by particles that lie in both, and every particle in a body.
void expectSound(const Actor& actor)
{
    ASSERT_EQ(actor.signedDistances.size(), actor.particles.size());
    ASSERT_EQ(actor.joints.size() + 1, actor.bodies.size());
    std::vector<int> timesChild(actor.bodies.size(), 0), memberships(actor.particles.size(), 0);
    for (const ActorBody& body : actor.bodies) {
        EXPECT_FALSE(body.particles.empty()) << body.name;
        for (uint32_t particle : body.particles) {
            ASSERT_LT(particle, actor.particles.size());
            ++memberships[particle];
        }
    }
    for (const ActorJoint& joint : actor.joints) {
        ++timesChild[joint.child];
        EXPECT_EQ(actor.bodies[joint.child].parent, static_cast<int32_t>(joint.parent));
        for (uint32_t particle : joint.sharedParticles) {
            EXPECT_TRUE(contains(actor.bodies[joint.parent].particles, particle)) << joint.name;
            EXPECT_TRUE(contains(actor.bodies[joint.child].particles, particle)) << joint.name;
        }
    }
    EXPECT_EQ(std::count(timesChild.begin(), timesChild.end(), 1),
              static_cast<std::ptrdiff_t>(actor.joints.size()));
    EXPECT_EQ(*std::min_element(memberships.begin(), memberships.end()), 1);
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        std::set<int32_t> above;
        for (int32_t body = static_cast<int32_t>(b); body >= 0; body = actor.bodies[body].parent) {
            ASSERT_TRUE(above.insert(body).second) << "the bodies form a ring";
        }
    }
}

void expectOnAxis(const Actor& actor, const ActorJoint& joint)
{
    ASSERT_GE(joint.sharedParticles.size(), 2u);
    for (uint32_t particle : joint.sharedParticles) {
        const Vector3f offset = actor.particles[particle] - joint.anchor;
        EXPECT_LT((offset - offset.dot(joint.axis) * joint.axis).norm(), 1e-5f) << joint.name;
    }
}

TEST(Articulate, humanoidBecomesATreeAtEveryDiameter)
{
    for (const float diameter : {0.08f, 0.05f, 0.04f, 0.03f, 0.02f}) {
        const Actor actor = make(makeHumanoid(), diameter);
        expectSound(actor);
        EXPECT_EQ(actor.diameter, diameter);
    }
    EXPECT_GE(make(makeHumanoid(), 0.04f).bodies.size(), 17u);
}

TEST(Articulate, jointsSitAtTheHeadsOfTheirBones)
{
    const Model model = makeHumanoid();
    for (const ActorJoint& joint : make(model, 0.04f).joints) {
        const auto bone = std::find_if(model.bones.begin(), model.bones.end(),
                                       [&](const Bone& b) { return b.name == joint.name; });
        ASSERT_NE(bone, model.bones.end());
        EXPECT_LT((joint.anchor - bone->restPose.block<3, 1>(0, 3)).norm(), 1e-5f) << joint.name;
    }
}

TEST(Articulate, kneesAndElbowsAreHingesWithTheirParticlesOnOneLine)
{
    const Actor actor = make(makeHumanoid(), 0.03f);
    int hinges = 0;
    for (const ActorJoint& joint : actor.joints) {
        if (joint.type == JointType::Hinge) {
            ++hinges;
            expectOnAxis(actor, joint);
        }
    }
    EXPECT_EQ(hinges, 4);
}

TEST(Articulate, kneesTurnAboutTheAxisFromLeftToRight)
{
    for (const ActorJoint& joint : make(makeHumanoid(), 0.04f).joints) {
        if (joint.name.starts_with("shin")) {
            EXPECT_GT(std::abs(joint.axis.x()), 0.95f);
        }
    }
}

TEST(Articulate, kneesHaveRoomBehindAndNoneInFront)
{
    const Actor actor = make(makeHumanoid(), 0.03f);
    for (const ActorJoint& joint : actor.joints) {
        if (!joint.name.starts_with("shin")) {
            continue;
        }
        size_t behind = 0, front = 0;
        for (const uint32_t body : {joint.parent, joint.child}) {
            for (const uint32_t particle : actor.bodies[body].particles) {
                const Vector3f offset = actor.particles[particle] - joint.anchor;
                const bool atKnee = std::abs(offset.y()) < 0.6f * actor.diameter;
                behind += atKnee && offset.z() < -0.8f * actor.diameter;
                front += atKnee && offset.z() > 0.5f * actor.diameter;
            }
        }
        EXPECT_EQ(behind, 0u);
        EXPECT_GT(front, 0u);
    }
}

TEST(Articulate, ballSharesOneParticleAtTheAnchor)
{
    const Actor actor = make(twoBoneBox("something"), 0.1f);
    expectSound(actor);
    ASSERT_EQ(actor.joints.size(), 1u);
    EXPECT_EQ(actor.joints[0].type, JointType::Ball);
    ASSERT_EQ(actor.joints[0].sharedParticles.size(), 1u);
    EXPECT_LT((actor.particles[actor.joints[0].sharedParticles[0]] - Vector3f(0, 0, 1)).norm(), 1e-6f);
}

TEST(Articulate, stiffSharesFourParticlesThatSpanAPlane)
{
    const Actor actor = make(twoBoneBox("spine"), 0.1f);
    expectSound(actor);
    const auto& shared = actor.joints.at(0).sharedParticles;
    ASSERT_EQ(std::set<uint32_t>(shared.begin(), shared.end()).size(), 4u);
    const Vector3f a = actor.particles[shared[0]];
    float area = 0.0f;
    for (uint32_t p : shared) {
        area = std::max(area, (actor.particles[p] - a).cross(actor.particles[shared[1]] - a).norm());
    }
    EXPECT_GT(area, actor.diameter * actor.diameter);
}

TEST(Articulate, universalPutsAFlatBodyBetweenTwoCrossedHinges)
{
    ArticulationOptions options;
    options.types["tip"] = JointType::Universal;
    const Actor actor = make(twoBoneBox("tip"), 0.1f, options);
    expectSound(actor);
    ASSERT_EQ(actor.bodies.size(), 3u);
    ASSERT_EQ(actor.joints.size(), 2u);
    const ActorBody& cross = actor.bodies[actor.joints[0].child];
    EXPECT_EQ(cross.name, "tip/cross");
    EXPECT_EQ(cross.particles.size(), 5u);
    EXPECT_NEAR(actor.joints[0].axis.dot(actor.joints[1].axis), 0.0f, 1e-6f);
    for (const ActorJoint& joint : actor.joints) {
        EXPECT_EQ(joint.type, JointType::Universal);
        EXPECT_EQ(joint.sharedParticles.size(), 2u);
        expectOnAxis(actor, joint);
    }
}

TEST(Articulate, overriddenAxisIsKept)
{
    ArticulationOptions options;
    options.types["tip"] = JointType::Hinge;
    options.axes["tip"] = {0, 2, 0};
    const Actor actor = make(twoBoneBox("tip"), 0.1f, options);
    EXPECT_EQ(actor.joints.at(0).axis, Vector3f(0, 1, 0));
    expectOnAxis(actor, actor.joints[0]);
}

TEST(Articulate, overrideForABoneThatIsNotThereIsRefused)
{
    ArticulationOptions options;
    options.types["wing"] = JointType::Ball;
    EXPECT_THROW(make(twoBoneBox("tip"), 0.1f, options), InputError);
}

TEST(Articulate, boneTooSmallForABodyMergesIntoItsParentAndIsNoted)
{
    Model model = twoBoneBox("tip", 0.02f);   // a rod: one row of particles, all on one line
    model.bones.push_back({"root2", -1});
    Model body = twoBoneBox("unused");
    for (size_t v = 0; v < 8; ++v) {          // a solid root so that there is a body at all
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

TEST(Articulate, smallBoneMergesIntoItsParentEvenWhereAnotherBodyIsNearer)
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

TEST(Articulate, partsThatDoNotTouchAreBridgedAtTheJoint)
{
    Model model = twoBoneBox("tip");
    for (size_t v = 8; v < 16; ++v) {
        model.vertices[v].z() += 0.4f;        // four diameters of air
    }
    model.bones[1].restPose(2, 3) = 1.2f;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

TEST(Articulate, secondRootJoinsTheNearestBody)
{
    Model model = twoBoneBox("tip");
    model.bones[1].parent = -1;
    const Actor actor = make(model, 0.1f);
    expectSound(actor);
    EXPECT_EQ(actor.joints.size(), 1u);
}

TEST(Articulate, modelWithoutBonesIsOneRigidBody)
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

TEST(Articulate, twoRunsGiveTheSameActor)
{
    const Actor a = make(makeHumanoid(), 0.03f), b = make(makeHumanoid(), 0.03f);
    EXPECT_EQ(a.particles, b.particles);
    ASSERT_EQ(a.bodies.size(), b.bodies.size());
    for (size_t i = 0; i < a.bodies.size(); ++i) {
        EXPECT_EQ(a.bodies[i].particles, b.bodies[i].particles);
    }
}

TEST(Articulate, worldBuiltFromAnActorHasItsBodiesAndSharedParticles)
{
    const Actor actor = make(makeHumanoid(), 0.05f);
    WorldBuilder builder(0.5f * actor.diameter);
    const uint32_t material = builder.addMaterial({});
    addActor(builder, actor, material, {{0, 3, 0}, Quaternionf::Identity()}, {1, 0, 0});
    const World world = builder.build();
    EXPECT_EQ(world.particles.size(), actor.particles.size());
    ASSERT_EQ(world.bodies.size(), actor.bodies.size());
    size_t links = 0, shared = 0;
    for (size_t b = 0; b < actor.bodies.size(); ++b) {
        EXPECT_EQ(world.bodies[b].linkCount, actor.bodies[b].particles.size()) << actor.bodies[b].name;
        links += actor.bodies[b].particles.size();
    }
    EXPECT_EQ(world.links.size(), links);
    for (const Particle& particle : world.particles) {
        shared += particle.bodyCount - 1;
    }
    EXPECT_EQ(shared, links - actor.particles.size());
    EXPECT_EQ(world.assemblyCount, 1u);
}

}  // namespace
}  // namespace knuckle
