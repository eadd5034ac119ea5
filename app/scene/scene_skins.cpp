#include <fmt/format.h>

#include <filesystem>

#include "app/scene/scene_parts.h"
#include "sim/actor/skin/skin_mesh.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

ModelSource sourceOf(const ObjectEntry& entry, const Actor& actor)
{
    const std::string file = existingFile(entry.context, entry.json["file"], entry.pointer + "/file");
    if (std::filesystem::path(file).extension() != ".json") return {file, {.scale = entry.json["scale"].get<double>()}};
    if (actor.model.file.empty())
        entry.fail("/skin", fmt::format("{} does not say of which `model` it was made; make it anew with knuckle "
                                        "voxelize, or take \"particles\"",
                                        file));
    if (!std::filesystem::is_regular_file(actor.model.file))
        entry.fail("/skin", fmt::format("{} was made of {}, which is not there; put it there, or take \"particles\"",
                                        file, actor.model.file));
    return actor.model;
}

std::shared_ptr<const SkinMesh> makeSkin(const ObjectEntry& entry, const Actor& actor)
{
    const Model& model = modelWithClips(entry.context, sourceOf(entry, actor), true);
    for (const std::string& note : model.surface.notes)
        entry.context.notes.push_back(fmt::format("{}/skin: {}", entry.pointer, note));
    try {
        return std::make_shared<const SkinMesh>(makeSkinMesh(actor, model));
    } catch (const InputError& error) {
        entry.fail("/skin", error.what());
    }
}

}  // namespace

bool showsSkin(const Json& object)
{
    return object.value("skin", "particles") != "particles";
}

void wearSkin(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects)
{
    SceneContext& context = entry.context;
    const std::string key = actorKey(context, entry.json, entry.json["file"], context.builder.diameter());
    if (!context.skins.contains(key)) context.skins[key] = makeSkin(entry, actor);
    context.builder.addSkin(context.skins[key], objects, entry.json["skin"] == "mesh");
}

}  // namespace knuckle
