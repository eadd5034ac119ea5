#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/files/actor_file.h"
#include "app/files/joints_file.h"
#include "app/scene/scene_file.h"
#include "app/scene/scene_parts.h"
#include "app/scene/scene_ropes.h"
#include "sim/actor/bodies/articulate.h"

namespace knuckle {

namespace {

std::string besideScene(const SceneContext& context, const std::string& file)
{
    return (std::filesystem::path(context.path).parent_path() / file).lexically_normal().string();
}

Actor loadActor(SceneContext& context, const Json& object, const std::string& file, const std::string& pointer)
{
    Actor actor = readActor(file);
    const float diameter = context.builder.diameter();
    if (!object["joints"].get<std::string>().empty()) {
        failAt(context.path, pointer + "/joints", "an actor file has its joints already; give the model as `file`");
    }
    if (std::abs(actor.diameter - diameter) > 1e-4f * diameter) {
        failAt(context.path, pointer + "/file",
               fmt::format("{} is made of particles of {} m, the scene of {} m; set /diameter to {}, or make the actor "
                           "with knuckle voxelize --diameter {}",
                           file, actor.diameter, diameter, actor.diameter, diameter));
    }
    return actor;
}

Model readModel(const Json& object, const std::string& file)
{
    ImportOptions options;
    options.scale = object["scale"];
    options.clips = false;
    return importModel(file, options);
}

Actor voxelizeModel(SceneContext& context, const Json& object, const std::string& file, float diameter)
{
    Model model = readModel(object, file);
    ActorOptions options;
    options.voxels.diameter = diameter;
    options.voxels.particleLimit = MAX_PARTICLES;
    if (object["type"] != "actor") {
        model.bones.clear();
        model.skin.clear();
    } else if (const std::string joints = object["joints"]; !joints.empty()) {
        readJoints(besideScene(context, joints), options.articulation);
    }
    return makeActor(model, options);
}

}  // namespace

std::string existingFile(const SceneContext& context, const std::string& file, const std::string& pointer)
{
    std::string path = besideScene(context, file);
    if (!std::filesystem::is_regular_file(path))
        failAt(context.path, pointer, fmt::format("there is no file {}; paths are relative to the scene", path));
    return path;
}

Model readClothModel(SceneContext& context, const Json& object, const std::string& pointer)
{
    return readModel(object, existingFile(context, object["file"], pointer + "/file"));
}

const Actor& findActor(SceneContext& context, const Json& object, const std::string& pointer, float diameter)
{
    if (diameter == 0.0f) diameter = context.builder.diameter();
    const std::string file = existingFile(context, object["file"], pointer + "/file");
    const std::string key =
        Json{file, object["type"], object.value("joints", ""), object.value("scale", 0.0), diameter}.dump();
    const auto found = context.actors.find(key);
    if (found != context.actors.end()) return found->second;
    const bool actorFile = object["type"] == "actor" && std::filesystem::path(file).extension() == ".json";
    Actor actor = actorFile ? loadActor(context, object, file, pointer)
                            : voxelizeModel(context, object, file, diameter);
    return context.actors.emplace(key, std::move(actor)).first->second;
}

}  // namespace knuckle
