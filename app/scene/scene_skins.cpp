#include <fmt/format.h>

#include <filesystem>

#include "app/scene/scene_parts.h"
#include "sim/actor/skin/skin_mesh.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

/// The model that an actor was made of. @throws InputError where it is not known, or not there.
const ModelSource& sourceOf(const ObjectEntry& entry, const Actor& actor)
{
    const std::string& model = actor.model.file;
    const auto refuse = [&](const std::string& why) {
        const std::string file = existingFile(entry.context, entry.json["file"], entry.pointer + "/file");
        entry.fail("/skin", file + why + ", or take \"particles\"");
    };
    if (model.empty()) refuse(" does not say of which `model` it was made; make it anew with knuckle voxelize");
    if (!std::filesystem::is_regular_file(model))
        refuse(fmt::format(" was made of {}, which is not there; put it there", model));
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
