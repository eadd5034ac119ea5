#include "render/layers/scene_things.h"

#include <algorithm>

#include "shared/thing_types.h"

namespace knuckle {

SceneThings::SceneThings(const World& world) : world_(world), objects_(world.particles.size(), 0)
{
    for (const Object& object : world.objects) names_.push_back(object.name);
    const auto fill = [&](uint32_t first, uint32_t end, uint32_t object) {
        std::fill(objects_.begin() + first, objects_.begin() + end, object);
    };
    for (const LooseGroup& group : world.looseGroups) {
        // Cloth and ropes are objects, too, without bodies.
        const auto same = std::ranges::find_if(
            world.objects, [&](const Object& object) { return object.bodyCount == 0 && object.name == group.name; });
        if (same == world.objects.end()) names_.push_back(group.name);
        fill(group.first, group.end,
             static_cast<uint32_t>(same == world.objects.end() ? names_.size() : same - world.objects.begin() + 1));
    }
    for (const SoftBody& soft : world.softBodies)
        fill(soft.particleStart, soft.particleStart + soft.particleCount, soft.object + 1);  // NO_INDEX becomes 0
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (const uint32_t body = world.particles[i].body; body != NO_INDEX)
            objects_[i] = world.bodies[body].object + 1;
}

PixelIds SceneThings::idsOf(const gpu::uvec2& thing) const
{
    const uint32_t index = thing.y;
    PixelIds ids;
    if (thing.x == THING_COLLIDER) ids.collider = index + 1;
    if (thing.x == THING_BODY) {
        const Body& body = world_.bodies.at(index);
        ids = {.object = body.object + 1, .body = index + 1, .material = body.material + 1};
    }
    if (thing.x == THING_PARTICLE) {
        const Particle& particle = world_.particles.at(index);
        ids = {.object = objects_[index],
               .body = particle.body + 1,
               .material = particle.material + 1,
               .particle = index + 1};
    }
    return ids;
}

}  // namespace knuckle
