#include "app/scene/scene_files.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>

#include "app/files/actor_file.h"
#include "app/files/assets.h"
#include "app/files/joints_file.h"
#include "app/scene/scene_limits.h"
#include "sim/base/files/endings.h"
#include "sim/rig/bodies/make_actor.h"

namespace knuckle {

namespace {

ModelSource sourceOf(const Json& object, const std::string& path)
{
    ModelPick pick{ALL_SKELETONS};
    if (object["type"] == "actor") pick = {object["skeleton"], object["split"]};
    return {path, {.scale = object["scale"].get<double>()}, pick};
}

}  // namespace

std::string SceneFiles::beside(const std::string& file) const
{
    std::string path = (std::filesystem::path(scene_).parent_path() / file).lexically_normal().string();
    std::error_code ignored;
    if (std::filesystem::exists(path, ignored)) return path;
    std::string asset = findAsset(file);
    return asset == file ? path : asset;
}

std::string SceneFiles::existing(const std::string& file, const std::string& pointer)
{
    std::string path = beside(file);
    if (!std::filesystem::is_regular_file(path))
        failAt(scene_, pointer, fmt::format("there is no file {}; paths are relative to the scene", path));
    read_.push_back(path);
    return path;
}

std::shared_ptr<const Model> SceneFiles::model(const Json& object, const std::string& path, bool clips)
{
    return model(sourceOf(object, path), clips);
}

std::shared_ptr<const Model> SceneFiles::model(const ModelSource& source, bool clips)
{
    return imports_->read(
        source.file, {.fit = source.fit, .clips = clips, .surface = drawn_.contains(source.file), .pick = source.pick});
}

std::shared_ptr<const Model> SceneFiles::drawnModel(const ModelSource& source) const
{
    return imports_->read(source.file, {.fit = source.fit, .clips = false, .surface = true, .pick = source.pick});
}

std::string SceneFiles::actorKey(const Json& object, float diameter) const
{
    return Json{beside(object["file"]),
                object["type"],
                object.value("joints", ""),
                object.value("scale", 0.0),
                object.value("skeleton", ""),
                object.value("split", false),
                diameter,
                isLimited(object)}
        .dump();
}

const Actor& SceneFiles::actor(const Json& object, const std::string& pointer, float diameter)
{
    const std::string path = existing(object["file"], pointer + "/file"), key = actorKey(object, diameter);
    if (const auto found = actors_.find(key); found != actors_.end()) return found->second;
    const bool isActorFile = object["type"] == "actor" && isActorName(path);
    try {
        Actor made = isActorFile ? load(object, path, pointer, diameter) : voxelize(object, path, pointer, diameter);
        if (diameter == 0.0f) actors_.emplace(actorKey(object, made.diameter), made);
        return actors_.emplace(key, std::move(made)).first->second;
    } catch (const SkeletonError& error) {
        failAt(scene_, pointer + "/skeleton",
               fmt::format("{}; give the name of one, or \"*\" for all as one", error.what()));
    }
}

Actor SceneFiles::load(const Json& object, const std::string& path, const std::string& pointer, float diameter) const
{
    Actor actor = readActor(path);
    if (!isLimited(object))
        for (ActorJoint& joint : actor.joints) joint.limits = {};
    for (const auto& [field, given] : {std::pair{"joints", !object["joints"].get<std::string>().empty()},
                                       std::pair{"skeleton", !object["skeleton"].get<std::string>().empty()},
                                       std::pair{"split", object["split"] == true}})
        if (given)
            failAt(scene_, fmt::format("{}/{}", pointer, field),
                   fmt::format("an actor file has its {} already; give the model as `file`",
                               std::string_view(field) == "split" ? "parts" : field));
    if (diameter > 0.0f && std::abs(actor.diameter - diameter) > 1e-4f * diameter)
        failAt(scene_, pointer + "/file",
               fmt::format("{} is made of particles of {} m, the scene of {} m; set /diameter to {}, or make the actor "
                           "with knuckle voxelize --diameter {}",
                           path, actor.diameter, diameter, actor.diameter, diameter));
    return actor;
}

Actor SceneFiles::voxelize(const Json& object, const std::string& path, const std::string& pointer, float diameter)
{
    const bool isActor = object["type"] == "actor";
    Model model = *this->model(object, path, isActor);  // clips show how joints turn
    ActorOptions options;
    options.voxels.diameter = diameter;
    options.voxels.particleLimit = MAX_PARTICLES;
    options.voxels.facets = object["type"] == "rigid";
    options.articulation.limited = isLimited(object);
    if (!isActor) {
        model.bones.clear();
        model.skin.clear();
    } else if (const std::string joints = object["joints"]; !joints.empty()) {
        if (model.isSplit) failAt(scene_, pointer + "/joints", "parts have none; take this or `split` away");
        read_.push_back(beside(joints));
        readJoints(read_.back(), options.articulation);
    }
    Actor actor = makeActor(model, options);
    actor.model = sourceOf(object, path);
    return actor;
}

bool showsSkin(const Json& object)
{
    return object.value("visible", true) && object.value("skin", "particles") != "particles";
}

}  // namespace knuckle
