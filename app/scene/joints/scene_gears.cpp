#include "app/scene/joints/scene_gears.h"

#include <fmt/format.h>

namespace knuckle {

namespace {

/// The hinge that a gear names.
const HingeBodies& hingeNamed(const SceneEntry& entry, size_t place)
{
    const std::string name = entry.json["joints"][place];
    const auto found = entry.context.hinges.find(name);
    if (found != entry.context.hinges.end()) return found->second;
    std::vector<std::string> known;
    for (const auto& [hinge, bodies] : entry.context.hinges) known.push_back(hinge);
    entry.fail(fmt::format("/joints/{}", place),
               fmt::format("there is no object \"{}\" of type `joint` and kind `hinge`; {}", name,
                           known.empty() ? "add it" : suggestion(name, known)));
}

}  // namespace

bool isGear(const Json& object)
{
    return object["type"] == "gear";
}

void noteGearedHinges(SceneContext& context, const Json& objects)
{
    for (const Json& object : objects)
        if (isGear(object))
            for (const Json& name : object["joints"]) context.gearedHinges.insert(name);
}

void addSceneGear(const SceneEntry& entry, size_t index)
{
    const HingeBodies &first = hingeNamed(entry, 0), &second = hingeNamed(entry, 1);
    if (first.child == second.child && first.parent == second.parent)
        entry.fail("/joints", "names one hinge twice; a gear couples two");
    const float ratio = entry.json["ratio"];
    if (ratio == 0.0f) entry.fail("/ratio", "must not be 0; for instance -1 for two equal wheels");
    entry.context.builder.addGear(objectName(entry.json, index), first, second, ratio);
}

}  // namespace knuckle
