// Structs and constants that C++ and GLSL share. Only 4-byte scalars and 16-byte vectors, so that both agree on every
// offset (std430); a test compares them with the driver's.
#ifndef KNUCKLE_GPU_TYPES_H
#define KNUCKLE_GPU_TYPES_H

#ifdef __cplusplus
#include <cstdint>
namespace knuckle::gpu {
using uint = std::uint32_t;
struct alignas(16) vec4 { float x, y, z, w; };
struct alignas(16) uvec4 { uint x, y, z, w; };
#endif

// The paper's listing 1, with the mass that the particle has in this body. Links are grouped by body.
struct ParticleRigidBodyLink {
    uint particleIndex;
    uint rbIndex;
    float posInRigidBodyX;          // r of eq. 8 [m]
    float posInRigidBodyY;
    float posInRigidBodyZ;
    uint particleLinksBlockStart;
    uint particleLinksBlockCount;
    float mass;                     // weight in eqs. 8-9 [kg]
};

// What never changes about a particle.
struct ParticleInfo {
    uint body;                      // first body, NO_INDEX for loose particles
    uint bodyCount;                 // 0 loose, 1 ordinary, 2 or more: a joint
    uint assembly;                  // bodies connected by joints, NO_INDEX for loose particles
    uint material;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
