#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shared/vector_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// What a pixel shows: numbers from 1 on, 0: none.
struct PixelIds {
    uint32_t object = 0;                                          ///< Index into SceneThings::names, and 1.
    uint32_t body = 0, material = 0, particle = 0, collider = 0;  ///< Indices into the World, and 1.
};

/// The objects of a scene, with and without bodies, and what belongs to each.
class SceneThings {
public:
    /// @param world must outlive it.
    explicit SceneThings(const World& world);

    /// World::objects, then those World::looseGroups that are none of them.
    const std::vector<std::string>& names() const { return names_; }
    /// @param thing THING_*, its index.
    PixelIds idsOf(const gpu::uvec2& thing) const;

private:
    const World& world_;
    std::vector<std::string> names_;
    std::vector<uint32_t> objects_;  ///< Of each particle, from 1 on.
};

}  // namespace knuckle
