#include "render/spheres/covered.h"

#include <algorithm>
#include <span>

#include "render/unseen.h"

namespace knuckle {

namespace {

void cover(std::vector<uint32_t>& bits, uint32_t particle)
{
    bits[particle / 32] |= 1u << particle % 32;
}

/// What a joint has put beside the shape is seen.
void coverInside(std::vector<uint32_t>& bits, const World& world, const BodyShape& shape)
{
    const Body& body = world.bodies[shape.body];
    for (const Link& link : std::span(world.links).subspan(body.linkStart, body.linkCount))
        if (shape.contains(body.restCentre + link.restOffset)) cover(bits, link.particle);
}

}  // namespace

bool coversParticles(const World& world)
{
    return !world.unseen.empty() || !world.bodyShapes.empty() ||
           std::ranges::find(world.skins, SkinUse::Hide, &Skin::use) != world.skins.end();
}

std::vector<uint32_t> coveredParticles(const World& world)
{
    std::vector<uint32_t> bits = unseenBits(world);
    for (const Skin& skin : world.skins) {
        if (skin.use != SkinUse::Hide) continue;
        for (const uint32_t index : skin.objects) {
            const Object& object = world.objects[index];
            for (uint32_t b = object.bodyStart; b < object.bodyEnd(); ++b)
                for (uint32_t l = 0; l < world.bodies[b].linkCount; ++l)
                    cover(bits, world.links[world.bodies[b].linkStart + l].particle);
        }
    }
    for (const BodyShape& shape : world.bodyShapes) coverInside(bits, world, shape);
    return bits;
}

}  // namespace knuckle
