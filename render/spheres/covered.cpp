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

std::span<const Link> linksOf(const World& world, const Body& body)
{
    return std::span(world.links).subspan(body.linkStart, body.linkCount);
}

/// Pins of the scene's joints, which weigh next to nothing. The layer between the boxes of a chain is no pin.
std::vector<uint32_t> pinBits(const World& world)
{
    std::vector<uint32_t> bits(world.particles.size() / 32 + 1, 0);
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (!world.particles[i].touchesAssembly) cover(bits, static_cast<uint32_t>(i));
    for (const Body& body : world.bodies) {
        if (!body.isCross) continue;
        for (const Link& link : linksOf(world, body)) bits[link.particle / 32] &= ~(1u << link.particle % 32);
    }
    return bits;
}

/// What is inside of shapes, and pins that hold them.
void coverShapes(std::vector<uint32_t>& bits, const World& world)
{
    const std::vector<uint32_t> pins = pinBits(world);
    for (const BodyShape& shape : world.bodyShapes) {
        const Body& body = world.bodies[shape.body];
        for (const Link& link : linksOf(world, body))
            if (hasBit(pins, link.particle) || shape.contains(body.restCentre + link.restOffset))
                cover(bits, link.particle);
    }
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
                for (const Link& link : linksOf(world, world.bodies[b])) cover(bits, link.particle);
        }
    }
    coverShapes(bits, world);
    return bits;
}

}  // namespace knuckle
