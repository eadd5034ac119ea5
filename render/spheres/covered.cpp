#include "render/spheres/covered.h"

#include <algorithm>

#include "render/unseen.h"

namespace knuckle {

bool coversParticles(const World& world)
{
    return !world.unseen.empty() || std::ranges::find(world.skins, SkinUse::Hide, &Skin::use) != world.skins.end();
}

std::vector<uint32_t> coveredParticles(const World& world)
{
    std::vector<uint32_t> bits = unseenBits(world);
    for (const Skin& skin : world.skins) {
        if (skin.use != SkinUse::Hide) continue;
        for (const uint32_t index : skin.objects) {
            const Object& object = world.objects[index];
            for (uint32_t b = object.bodyStart; b < object.bodyEnd(); ++b)
                for (uint32_t l = 0; l < world.bodies[b].linkCount; ++l) {
                    const uint32_t particle = world.links[world.bodies[b].linkStart + l].particle;
                    bits[particle / 32] |= 1u << particle % 32;
                }
        }
    }
    return bits;
}

}  // namespace knuckle
