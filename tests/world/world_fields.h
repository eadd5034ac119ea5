#pragma once

#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "sim/world/world.h"

namespace knuckle::test {

/// One of everything, whether or not the combination makes sense.
inline World oneOfEverything()
{
    World w;
    w.materials.resize(1);
    w.particles.resize(1);
    w.bodies.resize(1);
    w.links.resize(1);
    w.joints.resize(1);
    w.objects.resize(1);
    w.clips.push_back({.name = "", .roots = {{0, 0, 0}}, .turns = {Quaternionf::Identity()}});
    w.animations.resize(1);
    w.animations[0].plays.resize(1);
    w.puppets.resize(1);
    w.puppets[0].joints.resize(1);
    w.puppets[0].pins.resize(1);
    w.puppets[0].strength.resize(1);
    w.puppets[0].caught.emplace();
    w.releases.resize(1);
    w.colliders.resize(1);
    w.colliderMotions.resize(1);
    w.colliderMotions[0].places.resize(1);
    w.softBodies.resize(1);
    w.clusters.resize(1);
    w.clusterLinks.resize(1);
    w.strands.resize(1);
    w.colliderGrids.resize(1);
    w.skins.resize(1);
    w.emitters.resize(1);
    w.drains.resize(1);
    w.clothTriangles.resize(1);
    w.wind.emplace();
    w.forceFields.resize(1);
    return w;
}

template <typename T>
void change(T& value)
{
    if constexpr (std::is_same_v<T, bool>) value = !value;
    else if constexpr (std::is_same_v<T, std::string>) value += "x";
    else if constexpr (std::is_enum_v<T>) value = static_cast<T>(static_cast<int>(value) + 1);
    // Also changes infinity.
    else if constexpr (std::is_floating_point_v<T>) value = value == T(2) ? T(3) : T(2);
    else value += 1;
}
template <typename T>
void change(std::vector<T>& list)
{
    list.emplace_back();
}

struct Field {
    const char* name;
    std::function<void(World&)> change;
};
#define FIELD(path)                              \
    Field                                        \
    {                                            \
#path, [](World & w) { change(w.path); } \
    }

}  // namespace knuckle::test
