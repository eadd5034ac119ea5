#include "app/scene/scene_materials.h"

#include <fmt/format.h>

#include <utility>

#include "app/json/fields.h"

namespace knuckle {

void checkFriction(const SceneEntry& entry)
{
    const double staticFriction = entry.json.at("staticFriction"), kineticFriction = entry.json.at("kineticFriction");
    if (kineticFriction <= staticFriction) return;
    entry.fail("/kineticFriction", fmt::format("{} is above staticFriction, {}; lower it or raise the other",
                                               kineticFriction, staticFriction));
}

namespace {

/// What is drawn must be what there is.
void checkDraw(const SceneEntry& entry)
{
    const std::string draw = entry.json["draw"];
    if (entry.json["fluid"].get<bool>() && draw == "shape")
        entry.fail("/draw", "a fluid has no shape; take \"surface\" or \"particles\"");
}

}  // namespace

void addMaterials(SceneContext& context, const Json& materials)
{
    for (const auto& [name, json] : materials.items()) {
        const SceneEntry entry{context, json, "/materials/" + name};
        checkFriction(entry);
        checkDraw(entry);
        Material material = readFields<Material>(json);
        readFinish(json, material.finish);
        if (material.fluid) material.look.emission = std::exchange(material.finish.emission, 0.0f);
        if (material.fluid && material.finish != SurfaceFinish())
            entry.fail("/finish", "is for what is solid; a fluid looks as `color`, `absorption` and `scattering` say");
        material.name = name;
        context.materials[name] = context.builder.addMaterial(material);
    }
}

uint32_t findMaterial(const SceneContext& context, const std::string& name, const std::string& pointer)
{
    const auto found = context.materials.find(name);
    if (found != context.materials.end()) return found->second;
    std::vector<std::string> names;
    for (const auto& [known, index] : context.materials) names.push_back(known);
    failAt(context.path, pointer, fmt::format("there is no material \"{}\"; {}", name, suggestion(name, names)));
}

void requireFluid(const SceneContext& context, uint32_t material, const std::string& pointer)
{
    const Material& found = context.builder.material(material);
    if (!found.fluid)
        failAt(context.path, pointer,
               fmt::format("\"{}\" is not a fluid; give that material \"fluid\": true, or take another", found.name));
}

}  // namespace knuckle
