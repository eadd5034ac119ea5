#include "sim/rig/limbs/limb_fill.h"

#include "sim/rig/import/skeleton/skeleton_body.h"
#include "sim/rig/limbs/limb_owner.h"
#include "sim/rig/limbs/rods.h"
#include "tests/rig/actor_fixture.h"
#include "tools/humanoid/humanoid.h"

namespace knuckle {
namespace {

uint32_t addBone(Model& model, const std::string& name, int32_t parent, const Vector3f& head)
{
    Bone bone{name, parent};
    bone.restPose.block<3, 1>(0, 3) = head;
    model.bones.push_back(bone);
    return static_cast<uint32_t>(model.bones.size() - 1);
}

/// Hips, and a leg that points down, forward and to the side. Uses the program's own capsules: a thigh of 0.045 and a
/// shin of 0.033 of the figure's size, which is 1.72 m, in radius.
Model leg()
{
    Model model;
    model.name = "leg";
    addBone(model, "hips", -1, {0, 1.2f, 0});
    addBone(model, "spine", 0, {0, 1.9f, 0});
    addBone(model, "thigh.L", 0, {0.15f, 1.1f, 0});
    addBone(model, "shin.L", 2, {0.35f, 0.65f, 0.2f});
    addBone(model, "foot.L", 3, {0.5f, 0.18f, 0.1f});
    addBodyAlongBones(model, readAnatomy(model));
    return model;
}

const ActorBody& bodyOf(const Actor& actor, const std::string& name)
{
    const auto found = std::ranges::find(actor.bodies, name, &ActorBody::name);
    if (found == actor.bodies.end()) throw std::runtime_error("no body " + name);
    return *found;
}

bool isShared(const Actor& actor, uint32_t particle)
{
    return std::ranges::any_of(actor.joints,
                               [&](const ActorJoint& joint) { return contains(joint.sharedParticles, particle); });
}

/// The distinct distances, within 1 %, of the particles in the middle third of a limb from its bone.
std::set<int> distancesFromBone(const Actor& actor, const std::string& name, const Vector3f& head, const Vector3f& end)
{
    std::set<int> distances;
    const Vector3f along = (end - head).normalized();
    for (const uint32_t p : bodyOf(actor, name).particles) {
        const Vector3f from = actor.particles[p] - head;
        const float way = from.dot(along), part = way / (end - head).norm();
        if (isShared(actor, p) || part < 0.34f || part > 0.66f) continue;
        distances.insert(static_cast<int>(std::lround((from - way * along).norm() / (0.01f * actor.diameter))));
    }
    return distances;
}

TEST(LimbFill, limbIsRingsAroundItsBone)
{
    ActorOptions options{.name = {}, .voxels = {.diameter = 0.045f}, .articulation = {}};
    const Vector3f head(0.35f, 0.65f, 0.2f), end(0.5f, 0.18f, 0.1f);
    // 2.5 diameters across: one ring about one particle, or four, at one distance. Particles of the grid may be
    // anywhere.
    const Actor along = makeActor(leg(), options);
    EXPECT_LE(distancesFromBone(along, "shin.L", head, end).size(), 3u);
    expectSound(along);
    options.alongBones = false;
    const Actor grid = makeActor(leg(), options);
    EXPECT_GT(distancesFromBone(grid, "shin.L", head, end).size(), 6u);
}

TEST(LimbFill, bothSidesOfAFigureAreImages)
{
    const Model model = makeHumanoid();
    for (const float diameter : {0.028f, 0.0348f, 0.041f, 0.055f}) {
        for (const bool alongBones : {true, false}) {
            const Actor actor = makeActor(
                model, {.name = {}, .voxels = {.diameter = diameter}, .articulation = {}, .alongBones = alongBones});
            for (const ActorBody& body : actor.bodies) {
                if (!body.name.ends_with(".L")) continue;
                const ActorBody& other = bodyOf(actor, body.name.substr(0, body.name.size() - 1) + "R");
                EXPECT_EQ(body.particles.size(), other.particles.size()) << body.name << " at " << diameter;
                for (const uint32_t p : body.particles) {
                    const Vector3f image = actor.particles[p].cwiseProduct(Vector3f(-1, 1, 1));
                    float nearest = 1.0f;
                    for (const uint32_t q : other.particles)
                        nearest = std::min(nearest, (actor.particles[q] - image).norm());
                    // The skeleton's plane is known within the rounding of its bones' places.
                    EXPECT_LT(nearest, 1e-4f) << body.name << " at " << diameter;
                }
            }
        }
    }
}

TEST(LimbFill, jointsGapeByADiameterAtMost)
{
    for (const float diameter : {0.025f, 0.033f, 0.04f, 0.05f, 0.07f}) {
        const Actor actor = make(makeHumanoid(), diameter);
        for (const ActorJoint& joint : actor.joints) {
            float nearest = 10.0f;
            for (const uint32_t p : actor.bodies[joint.parent].particles)
                for (const uint32_t q : actor.bodies[joint.child].particles)
                    if (!isShared(actor, p) && !isShared(actor, q))
                        nearest = std::min(nearest, (actor.particles[p] - actor.particles[q]).norm());
            // Between surfaces: particles are a diameter apart where they touch. Slices of limbs are up to 1.2 apart.
            EXPECT_LE(nearest, 2.1f * diameter) << joint.name << " at " << diameter;
        }
    }
}

TEST(LimbFill, rodKeepsItsJoints)
{
    // A thigh of 0.15 m and a shin of 0.11 m across, filled with particles of 0.16 m.
    const Actor actor = make(leg(), 0.16f);
    expectSound(actor);
    ASSERT_EQ(actor.bodies.size(), 3u);
    const ActorBody& thigh = bodyOf(actor, "thigh.L");
    EXPECT_LE(thigh.particles.size(), 8u);
    // Its moment about its own bone is that of particles a sixth of a diameter away, not that of a line.
    const Vector3f head = actor.joints[0].anchor, along = (actor.joints[1].anchor - head).normalized();
    float moment = 0.0f;
    for (const uint32_t p : thigh.particles)
        moment += (actor.particles[p] - head).cross(along).squaredNorm() / static_cast<float>(thigh.particles.size());
    EXPECT_GT(moment, 0.028f * actor.diameter * actor.diameter);
}

TEST(LimbFill, rodsTakeThePlacesOfOthers)
{
    const Model model = leg();
    const Figure figure = readFigure(model);
    const Solid solid(model.vertices, model.triangles);
    Voxels voxels = voxelize(solid, {.diameter = 0.16f});
    LimbOwner owner(figure);
    std::vector<uint32_t> bones;
    for (const Vector3f& place : voxels.positions) bones.push_back(owner.at(solid.tree().nearestAround(place)));
    Voxels wound = voxels;
    std::vector<uint32_t> woundBones = bones;
    windRods(figure, solid, wound, woundBones);
    // A particle of the hips beside one that the thigh gets.
    const auto thigh = std::ranges::find(woundBones, 2u);
    ASSERT_NE(thigh, woundBones.end());
    voxels.add(solid, wound.positions[static_cast<size_t>(thigh - woundBones.begin())] + Vector3f(0.01f, 0, 0));
    bones.push_back(0);
    windRods(figure, solid, voxels, bones);
    EXPECT_EQ(voxels.positions, wound.positions);
}

TEST(LimbFill, lostJointIsToldWithTheDiameterThatKeepsIt)
{
    const Actor coarse = make(leg(), 0.25f);
    const auto told = std::ranges::find_if(
        coarse.notes, [](const std::string& note) { return note.starts_with("thigh.L has no joint of its own"); });
    ASSERT_NE(told, coarse.notes.end());
    const float enough = std::stof(told->substr(told->find("--diameter ") + 11));
    EXPECT_NO_THROW(bodyOf(make(leg(), enough), "thigh.L"));
}

}  // namespace
}  // namespace knuckle
