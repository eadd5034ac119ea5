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

/// What cloth, ropes and soft bodies are made of; not what a rope is tied to.
void coverMatter(std::vector<uint32_t>& bits, const World& world)
{
    const auto isOwn = [&](uint32_t particle) {
        const uint32_t body = world.particles[particle].body;
        return body == NO_INDEX || (world.bodies[body].motion == Motion::Fixed && world.bodies[body].linkCount == 1);
    };
    for (const ClothSurface& sheet : world.drawn.cloth)
        for (const uint32_t node : sheet.nodes) cover(bits, node);
    for (const uint32_t rope : world.drawn.ropes)
        for (const uint32_t node : world.strands[rope].particles)
            if (isOwn(node)) cover(bits, node);
    for (const SoftSurface& surface : world.drawn.soft) {
        const SoftBody& body = world.softBodies[surface.softBody];
        for (uint32_t k = 0; k < body.particleCount; ++k) cover(bits, body.particleStart + k);
    }
}

}  // namespace

bool coversParticles(const World& world)
{
    const DrawnMatter& drawn = world.drawn;
    return !world.unseen.empty() || !world.bodyShapes.empty() || !drawn.cloth.empty() || !drawn.ropes.empty() ||
           !drawn.soft.empty() || std::ranges::find(world.skins, SkinUse::Hide, &Skin::use) != world.skins.end();
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
    coverMatter(bits, world);
    return bits;
}

}  // namespace knuckle
