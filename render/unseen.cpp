#include "render/unseen.h"

namespace knuckle {

using Eigen::AlignedBox3f;

std::vector<uint32_t> unseenBits(const World& world)
{
    std::vector<uint32_t> bits(world.particles.size() / 32 + 1, 0);
    for (const ParticleRange& range : world.unseen)
        for (uint32_t particle = range.first; particle < range.end; ++particle)
            bits[particle / 32] |= 1u << particle % 32;
    return bits;
}

AlignedBox3f seenBounds(const World& world)
{
    const std::vector<uint32_t> unseen = unseenBits(world);
    AlignedBox3f box;
    for (size_t i = 0; i < world.particles.size(); ++i)
        if (!hasBit(unseen, i)) box.extend(world.particles[i].position);
    if (box.isEmpty()) return box;
    const Vector3f radius = Vector3f::Constant(world.particleRadius);
    return {box.min() - radius, box.max() + radius};
}

}  // namespace knuckle
