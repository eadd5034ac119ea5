#include "app/export/rig.h"

#include <algorithm>
#include <filesystem>

#include "sim/rig/import/imports.h"
#include "sim/rig/skin/skin_mesh.h"

namespace knuckle {

namespace {

/// @param surface whether its looks are needed. @returns it without clips.
Model readModel(Imports& imports, const SceneActor& use, bool surface)
{
    const ModelSource& source = use.actor->model;
    Model model = *imports.read(source.file,
                                {.fit = source.fit, .clips = false, .surface = surface, .pick = source.pick});
    model.clips.clear();
    model.unusableClips.clear();
    return model;
}

/// The joint by which a body hangs on another; for the first body, the middle of its particles.
Vector3f headOf(const Actor& actor, uint32_t body)
{
    const auto joint = std::ranges::find(actor.joints, body, &ActorJoint::child);
    if (joint != actor.joints.end()) return joint->anchor;
    Vector3f sum = Vector3f::Zero();
    for (const uint32_t particle : actor.bodies[body].particles) sum += actor.particles[particle];
    return sum / static_cast<float>(actor.bodies[body].particles.size());
}

/// A skeleton of an actor's bodies, for actors without another one. @param bodies gets the body of each bone.
Model skeletonOf(const Actor& actor, std::vector<uint32_t>& bodies)
{
    Model model;
    std::vector<int32_t> boneOf(actor.bodies.size(), -1);
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        if (actor.bodies[b].isCross) continue;
        const int32_t parent = parentBody(actor, b);
        boneOf[b] = static_cast<int32_t>(model.bones.size());
        Bone bone{actor.bodies[b].name, parent < 0 ? -1 : boneOf[static_cast<size_t>(parent)]};
        bone.restPose.block<3, 1>(0, 3) = headOf(actor, b);
        model.bones.push_back(bone);
        bodies.push_back(b);
    }
    return model;
}

/// Adds bones to a model without bones, whose one body moves all.
void giveBodies(const Actor& actor, Rig& rig)
{
    rig.bodies.clear();
    rig.model.bones = skeletonOf(actor, rig.bodies).bones;
    SkinWeights whole;
    whole.weights[0] = 1.0f;
    rig.model.skin.assign(rig.model.vertices.size(), whole);
}

}  // namespace

std::vector<Rig> rigsOf(const Scene& scene, bool surface)
{
    std::vector<Rig> rigs;
    for (const SceneActor& use : scene.actors) {
        Rig rig;
        if (std::filesystem::is_regular_file(use.actor->model.file)) {
            rig.model = readModel(*scene.imports, use, surface);
            rig.bodies = bodiesOfBones(*use.actor, rig.model);
        }
        if (rig.model.bones.empty()) giveBodies(*use.actor, rig);
        for (const uint32_t object : use.objects) {
            Rig& copy = rigs.emplace_back(rig);
            copy.object = object;
            copy.model.name = scene.world.objects[object].name;
            for (uint32_t& body : copy.bodies) body += scene.world.objects[object].bodyStart;
        }
    }
    std::ranges::stable_sort(rigs, {}, &Rig::object);
    return rigs;
}

Eigen::Isometry3f motionOf(const Body& body, const BodyState& state)
{
    return Eigen::Translation3f(state.position) * state.rotation * Eigen::Translation3f(-body.restCentre);
}

void addRigidVertex(Rig& rig, uint32_t bone, const Vector3f& place, const Vector3f& normal, const Vector3f& color)
{
    SkinWeights skin;
    skin.bones[0] = bone;
    skin.weights[0] = 1.0f;
    rig.model.vertices.push_back(place);
    rig.model.skin.push_back(skin);
    rig.model.surface.vertices.push_back({normal, {0, 0}, color});
}

}  // namespace knuckle
