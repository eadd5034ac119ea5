#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include <algorithm>

#include "app/files/actor_file.h"
#include "app/files/joints_file.h"
#include "app/json/fields.h"
#include "app/json/joint_limits.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_fill.h"
#include "app/scene/scene_parts.h"
#include "app/scene/scene_ropes.h"
#include "sim/base/files/endings.h"
#include "sim/rig/bodies/make_actor.h"

namespace knuckle {

namespace {

bool isLimited(const SceneContext& context, const Json& actor)
{
    return actor.value("limits", false) && context.builder.world().settings.solver == SolverKind::Impulse;
}

Actor loadActor(SceneContext& context, const Json& object, const std::string& file, const std::string& pointer)
{
    Actor actor = readActor(file);
    if (!isLimited(context, object))
        for (ActorJoint& joint : actor.joints) joint.limits = {};
    const float diameter = context.builder.diameter();
    for (const auto& [field, given] : {std::pair{"joints", !object["joints"].get<std::string>().empty()},
                                       std::pair{"skeleton", !object["skeleton"].get<std::string>().empty()},
                                       std::pair{"split", object["split"] == true}})
        if (given)
            failAt(context.path, fmt::format("{}/{}", pointer, field),
                   fmt::format("an actor file has its {} already; give the model as `file`",
                               std::string_view(field) == "split" ? "parts" : field));
    if (std::abs(actor.diameter - diameter) > 1e-4f * diameter) {
        failAt(context.path, pointer + "/file",
               fmt::format("{} is made of particles of {} m, the scene of {} m; set /diameter to {}, or make the actor "
                           "with knuckle voxelize --diameter {}",
                           file, actor.diameter, diameter, actor.diameter, diameter));
    }
    return actor;
}

/// @param diameter of its particles [m]; 0: what fits it.
Actor voxelizeModel(SceneContext& context, const Json& object, const std::string& file, const std::string& pointer,
                    float diameter)
{
    const bool isActor = object["type"] == "actor";
    Model model = *readModel(context, modelOf(object, file), isActor);  // clips show how joints turn
    ActorOptions options;
    options.voxels.diameter = diameter;
    options.voxels.particleLimit = MAX_PARTICLES;
    options.articulation.limited = isLimited(context, object);
    if (!isActor) {
        model.bones.clear();
        model.skin.clear();
    } else if (const std::string joints = object["joints"]; !joints.empty()) {
        if (model.isSplit) failAt(context.path, pointer + "/joints", "parts have none; take this or `split` away");
        context.files.push_back(besideScene(context, joints));
        readJoints(context.files.back(), options.articulation);
    }
    Actor actor = makeActor(model, options);
    actor.model = modelOf(object, file);
    return actor;
}

/// Indices of the bodies of an actor that the scene holds.
std::vector<uint32_t> heldBodies(const ObjectEntry& entry, const Actor& actor)
{
    std::vector<uint32_t> held;
    if (entry.json["fixed"].get<bool>())
        for (uint32_t b = 0; b < actor.bodies.size(); ++b) held.push_back(b);
    const Json& wanted = entry.json["hold"];
    for (size_t i = 0; i < wanted.size(); ++i)
        held.push_back(bodyNamed(entry, actor, wanted[i], fmt::format("/hold/{}", i)));
    return held;
}

/// What is held at two places is a loop, which needs joints without limits: those of all held bodies but the first.
void freeHeldJoints(Actor& actor, const std::vector<uint32_t>& held)
{
    for (ActorJoint& joint : actor.joints)
        for (size_t i = 1; i < held.size(); ++i)
            if (joint.child == held[i] || joint.parent == held[i]) joint.limits = {};
}

[[noreturn]] void failForSkeleton(const SceneContext& context, const std::string& pointer, const SkeletonError& error)
{
    failAt(context.path, pointer + "/skeleton",
           fmt::format("{}; give the name of one, or \"*\" for all as one", error.what()));
}

bool isActorFile(const std::string& file)
{
    return endingOf(file) == ".json";
}

}  // namespace

std::string besideScene(const SceneContext& context, const std::string& file)
{
    return (std::filesystem::path(context.path).parent_path() / file).lexically_normal().string();
}

std::string existingFile(SceneContext& context, const std::string& file, const std::string& pointer)
{
    std::string path = besideScene(context, file);
    if (!std::filesystem::is_regular_file(path))
        failAt(context.path, pointer, fmt::format("there is no file {}; paths are relative to the scene", path));
    context.files.push_back(path);
    return path;
}

std::shared_ptr<const Model> readClothModel(SceneContext& context, const Json& object, const std::string& pointer)
{
    return readModel(context, modelOf(object, existingFile(context, object["file"], pointer + "/file")), false);
}

ModelSource modelOf(const Json& object, const std::string& file)
{
    ModelPick pick{ALL_SKELETONS};
    if (object["type"] == "actor") pick = {object["skeleton"], object["split"]};
    return {file, {.scale = object["scale"].get<double>()}, pick};
}

std::string actorKey(const SceneContext& context, const Json& object, const std::string& file, float diameter)
{
    return Json{file,
                object["type"],
                object.value("joints", ""),
                object.value("scale", 0.0),
                object.value("skeleton", ""),
                object.value("split", false),
                diameter,
                isLimited(context, object)}
        .dump();
}

std::shared_ptr<const Model> readModel(SceneContext& context, const ModelSource& source, bool clips)
{
    return context.imports->read(
        source.file,
        {.fit = source.fit, .clips = clips, .surface = context.drawnFiles.contains(source.file), .pick = source.pick});
}

const Actor& findActor(SceneContext& context, const Json& object, const std::string& pointer, float diameter)
{
    if (diameter == 0.0f) diameter = context.builder.diameter();
    const std::string file = existingFile(context, object["file"], pointer + "/file");
    const std::string key = actorKey(context, object, file, diameter);
    const auto found = context.actors.find(key);
    if (found != context.actors.end()) return found->second;
    const bool actorFile = object["type"] == "actor" && isActorFile(file);
    try {
        Actor actor = actorFile ? loadActor(context, object, file, pointer)
                                : voxelizeModel(context, object, file, pointer, diameter);
        return context.actors.emplace(key, std::move(actor)).first->second;
    } catch (const SkeletonError& error) {
        failForSkeleton(context, pointer, error);
    }
}

const Actor& actorAlone(SceneContext& context, const Json& object, const std::string& pointer)
{
    const std::string file = existingFile(context, object["file"], pointer + "/file");
    const std::string key = actorKey(context, object, file, 0.0f);
    const auto found = context.actors.find(key);
    if (found != context.actors.end()) return found->second;
    try {
        Actor actor = isActorFile(file) ? readActor(file) : voxelizeModel(context, object, file, pointer, 0.0f);
        if (!isActorFile(file)) context.actors.emplace(actorKey(context, object, file, actor.diameter), actor);
        return context.actors.emplace(key, std::move(actor)).first->second;
    } catch (const SkeletonError& error) {
        failForSkeleton(context, pointer, error);
    }
}

std::vector<std::string> bodyNames(const Actor& actor)
{
    std::vector<std::string> names;
    for (const ActorBody& body : actor.bodies) names.push_back(body.name);
    return names;
}

uint32_t bodyNamed(const ObjectEntry& entry, const Actor& actor, const std::string& name, const std::string& where)
{
    const std::vector<std::string> known = bodyNames(actor);
    const auto found = std::ranges::find(known, name);
    if (found == known.end())
        entry.fail(where, fmt::format("there is no body \"{}\"; {}", name, suggestion(name, known)));
    return static_cast<uint32_t>(found - known.begin());
}

void addActors(const ObjectEntry& entry)
{
    Actor actor = findActor(entry.context, entry.json, entry.pointer);
    limitParticles(entry.context, entry.json, entry.pointer, static_cast<double>(actor.particles.size()));
    const JointStrength strength = readStrength(entry.json);
    for (ActorJoint& joint : actor.joints)
        if (!joint.strength.tears()) joint.strength = strength;
    const std::vector<uint32_t> held = heldBodies(entry, actor);
    freeHeldJoints(actor, held);
    const bool animated = isAnimated(entry.json);
    if (animated && !held.empty()) entry.fail("/animation", "is for what is not held; take `fixed` and `hold` away");
    PlayedClips clips;
    if (animated) {
        clips = readClips(entry, actor);
        allow(actor, clips.needs);
    }
    std::vector<uint32_t> objects;
    WorldBuilder& builder = entry.context.builder;
    for (size_t copy = 0; copy < entry.poses.size(); ++copy) {
        actor.name = entry.copyName(copy);
        objects.push_back(addActor(builder, actor, entry.material, entry.poses[copy], entry.velocity));
        for (const uint32_t body : held) builder.holdBody(builder.world().objects[objects.back()].bodyStart + body);
    }
    entry.context.actorUses.push_back({std::make_shared<const Actor>(actor), objects});
    if (animated) animateActors(entry, actor, objects, clips.plays);
    driveActors(entry, actor, objects);
    releaseActors(entry, actor, objects);
    if (showsSkin(entry.json)) wearSkin(entry, actor, objects);
}

}  // namespace knuckle
