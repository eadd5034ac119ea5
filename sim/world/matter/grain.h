#pragma once

#include <cstdint>

namespace knuckle {

struct Material;
struct World;

/// Particle::scale of a grain: grains have two sizes in random order, since balls of one size pack as a crystal, which
/// stands as steep as its planes whatever its friction is. @param k its place in its object.
float grainScale(uint32_t k);
/// Of the largest particle of a world, 1 at least.
float largestScale(const World& world);

/// Coulomb's coefficients between two grains of a material.
struct GrainFriction {
    float sticking = 0.0f, sliding = 0.0f;
};

/// The coefficients with which grains, which cannot turn, heap at the arc tangent of their static and rolling friction
/// together (fitted: docs/decisions/12-grains.md).
GrainFriction grainFriction(const Material& material);

}  // namespace knuckle
