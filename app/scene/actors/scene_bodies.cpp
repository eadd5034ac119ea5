#include "app/scene/actors/scene_bodies.h"

#include <fmt/format.h>

#include <algorithm>

namespace knuckle {

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

}  // namespace knuckle
