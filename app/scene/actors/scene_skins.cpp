#include "app/scene/actors/scene_skins.h"

#include <fmt/format.h>

#include <filesystem>

#include "sim/base/errors.h"
#include "sim/rig/skin/skin_mesh.h"

namespace knuckle {

namespace {

bool isAutomatic(const ObjectEntry& entry)
{
    return entry.json["skin"] == "auto";
}

/// Why an actor has no mesh to draw; empty if it has one.
std::string whyNoMesh(const Actor& actor)
{
    const std::string& model = actor.model.file;
    if (model.empty()) return " does not say of which `model` it was made; make it anew with knuckle voxelize";
    if (!std::filesystem::is_regular_file(model))
        return fmt::format(" was made of {}, which is not there; put it there", model);
    return {};
}

/// Null if there is no mesh and it is optional. @throws InputError if it is required and cannot be made.
std::shared_ptr<const SkinMesh> makeSkin(const ObjectEntry& entry, const Actor& actor)
{
    SceneContext& context = entry.context;
    const auto without = [&](const std::string& why) {
        if (!isAutomatic(entry)) entry.fail("/skin", why + ", or take \"particles\"");
        context.warnings.push_back(fmt::format("{}: its particles are drawn: {}", entry.pointer, why));
        return nullptr;
    };
    if (const std::string why = whyNoMesh(actor); !why.empty())
        return without(context.files.existing(entry.json["file"], entry.pointer + "/file") + why);
    try {
        const std::shared_ptr<const Model> source = context.files.drawnModel(actor.model);
        const Model& model = *source;
        if (isAutomatic(entry) && model.surface.vertices.empty()) return nullptr;
        for (const std::string& what : model.surface.missing)
            context.warnings.push_back(fmt::format("{}/skin: {}", entry.pointer, what));
        for (const std::string& note : model.surface.notes)
            context.notes.push_back(fmt::format("{}/skin: {}", entry.pointer, note));
        return std::make_shared<const SkinMesh>(makeSkinMesh(actor, model));
    } catch (const InputError& error) {
        return without(error.what());
    }
}

SkinUse useOf(const std::string& skin)
{
    if (skin == "both") return SkinUse::Cover;
    return skin == "colors" ? SkinUse::Paint : SkinUse::Hide;
}

}  // namespace

void wearSkin(const ObjectEntry& entry, const Actor& actor, const std::vector<uint32_t>& objects)
{
    SceneContext& context = entry.context;
    const std::string key = context.files.actorKey(entry.json, context.builder.diameter());
    if (!context.skins[key]) context.skins[key] = makeSkin(entry, actor);
    if (context.skins[key]) context.builder.addSkin(context.skins[key], objects, useOf(entry.json["skin"]));
}

}  // namespace knuckle
