// Structs and constants that C++ and GLSL share. Only 4-byte scalars and 16-byte vectors, so that both agree on every
// offset (std430 and std140); a test compares them with the driver's.
#ifndef KNUCKLE_GPU_TYPES_H
#define KNUCKLE_GPU_TYPES_H

// Threads in a work group. llvmpipe is 30-40 % slower at 256.
#define GROUP_SIZE 64
// Threads that reduce one body together, where ReductionKind::Group is chosen.
#define BODY_GROUP_SIZE 32
// Cells that one thread of the prefix sum adds up.
#define CELLS_PER_CHUNK 64
// Colliders that one particle can touch at a time.
#define COLLIDER_SLOTS 4
// "Belongs to nothing", as in sim/world/world.h.
#define NO_BODY 0xffffffffu

// ColliderShape of sim/world/world.h.
#define COLLIDER_PLANE 0u
#define COLLIDER_BOX 1u
#define COLLIDER_SPHERE 2u
#define COLLIDER_CAPSULE 3u

// Bits of Counters::problems.
#define PROBLEM_CONTACTS 1u
#define PROBLEM_COLLIDERS 2u
#define PROBLEM_NAN 4u

#ifdef __cplusplus
#include <cstdint>
namespace knuckle::gpu {
using uint = std::uint32_t;
struct alignas(16) vec4 { float x, y, z, w; };
struct alignas(16) uvec4 { uint x, y, z, w; };
struct alignas(8) uvec2 { uint x, y; };
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
    uint body;                      // first body, NO_BODY for loose particles
    uint bodyCount;                 // 0 loose, 1 ordinary, 2 or more: a joint
    uint assembly;                  // bodies connected by joints; a loose particle is an assembly of its own
    uint material;
};

// What never changes about a body.
struct BodyInfo {
    uint linkStart;                 // its block of links; shared particles come last in it
    uint linkCount;
    uint ownCount;                  // links before the first shared particle
    uint jointCount;                // links of shared particles
};

struct GpuCollider {
    vec4 position;                  // xyz [m]; w: COLLIDER_*, as a float
    vec4 orientation;               // quaternion xyzw
    vec4 size;                      // box: half extents; sphere, capsule: radius, half height [m]
    vec4 friction;                  // static, kinetic
};

// Everything a step needs to know; uploaded once.
struct StepParameters {
    vec4 gravity;                   // xyz [m/s2]
    uint particleCount;
    uint bodyCount;
    uint linkCount;
    uint colliderCount;
    uint contactSlots;              // candidates that one particle can hold
    uint cellMask;                  // cells - 1, cells a power of two
    uint cellStrideY;               // lattice grid: cells between neighbours in y ...
    uint cellStrideZ;               // ... and in z
    float diameter;                 // [m]
    float contactRadius;            // candidates are nearer than this [m]
    float inverseCellSize;          // [1/m]
    float drift;                    // a particle that has moved further makes the candidates due again [m]
    float substepTime;              // [s]
    float correction;               // share of a penetration that one substep takes back
    float relaxation;               // of the impulses' Jacobi iteration
    float warmStart;                // share of the last substep's impulses that starts this one
    float virtualParticles;         // c of eq. 18
    float freeze;                   // [m], 0 off
    float damping;                  // velocity kept per substep
    float maxSpeed;                 // [m/s]
    uint secondOrder;               // 1: BDF2 where nothing touches
    uint alwaysFind;                // 1: candidates every substep (the paper), 0: when due
    uint rotationIterations;
    float maxCorrection;            // of a penetration per substep [m]
    float jointRelaxation;          // of the joints' impulses
    uint sharedCount;               // particles of two or more bodies
    uint pad0;
    float impulseGrowth;            // how fast a warm start may grow: an acceleration times substepTime^2 [m]
};

// Written by kernels, read once a frame. 64 bytes.
struct Counters {
    uint problems;                  // PROBLEM_*
    uint wantedContacts;            // largest number of candidates a particle would have had
    uint wantedColliders;
    uint badParticle;               // one particle that turned NaN
    uint substep;                   // substeps since the start
    uint due;                       // somebody has used up its margin
    uint listParity;                // which half of the candidate lists is current
    uint findCount;                 // times the candidates were found
    uint candidateCount;            // candidates in the current lists, both sides counted
    uint pad0;
    uint pad1;
    uint pad2;
    uint pad3;
    uint pad4;
    uint pad5;
    uint pad6;
};

#ifdef __cplusplus
static_assert(sizeof(ParticleRigidBodyLink) == 32 && sizeof(Counters) == 64 && sizeof(GpuCollider) == 64);
}  // namespace knuckle::gpu
#endif
#endif
