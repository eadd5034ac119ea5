// Structs that C++ and GLSL share. Only 4-byte scalars and 16-byte vectors, so that both agree on every
// offset (std430 and std140); a test compares them with the driver's.
#ifndef KNUCKLE_GPU_TYPES_H
#define KNUCKLE_GPU_TYPES_H

#include "shared/constants.h"

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
    uint body;                      // first body, NO_INDEX for loose particles
    uint bodyCount;                 // 0 loose, 1 ordinary, 2 or more: a joint
    uint assembly;                  // bodies connected by joints; a loose particle is an assembly of its own
    uint material;
};

// Where a particle stands in the order of contact lists: by mover, then by its own index.
struct ParticleRank {
    uint mover;
    uint rank;
};

// What never changes about a body.
struct BodyInfo {
    uint linkStart;                 // its block of links; shared particles come last in it
    uint linkCount;
    uint ownCount;                  // links before the first shared particle
    uint jointCount;                // links of shared particles
};

// What never changes about a mover: a body, or a loose particle, which is a body that cannot turn. Bodies come first.
struct MoverInfo {
    uint firstRank;                 // its particles in the order of contact lists
    uint rankCount;
    uint assembly;
    float inverseMass;              // [1/kg], 0: fixed
};

// What never changes about a cluster of a soft body.
struct ClusterInfo {
    uint linkStart;                 // its block of links, behind those of all bodies; their rbIndex is the cluster
    uint linkCount;
    uint softBody;
    uint assembly;
};

// What a soft body is made of; moduli over its density.
struct GpuSoftMatter {
    float shear;                    // twice the shear modulus (Lame's mu) [m2/s2]
    float dilation;                 // Lame's lambda [m2/s2]
    float damping;                  // [s]
    float steepest;                 // no force grows by more than this times mass and displacement [1/s2]
    float yield;                    // strain
    float creep;                    // [1/s]
    float maxDeformation;
    float unused;
};

struct GpuCollider {
    vec4 position;                  // xyz [m]; w: COLLIDER_*, as a float
    vec4 orientation;               // quaternion xyzw
    vec4 size;                      // box: half extents; sphere, capsule: radius, half height; grids: a cell [m]
    vec4 friction;                  // static, kinetic
    vec4 gridLow;                   // where the first value stands [m]
    uvec4 grid;                     // values along x, y, z; the first in gridValues
};

// What never changes about an emitter.
struct GpuEmitter {
    vec4 velocity;                  // of what leaves it [m/s]; w: fluid nearer than this is in the way [m]
    uvec4 clock;                    // layers that are past at startStep and a step, both 64 bits of 2^-32, low first
    uint startStep;                 // layers leave at the end of this step at the earliest
    uint layerLimit;                // as many leave until it stops
    uint firstPoint;                // in nozzlePoints
    uint pointCount;                // particles of a layer
    uint poolStart;                 // in poolOrder
    uint poolCount;
    uint takesOldest;
    float interval;                 // between layers [s]
};

// What an emitter does in a step.
struct EmitterState {
    uint taken;                     // inactive particles that it takes
    uint retired;                   // its oldest particles that it makes inactive
    uint inactive;                  // particles, before that
    float age;                      // time since the last layer left [s]
    uint firstCandidate;            // its first thread in fluid_emit
    uint unused0;
    uint unused1;
    uint unused2;
};

// Everything a step needs to know; uploaded once.
struct StepParameters {
    vec4 gravity;                   // xyz [m/s2]
    uint particleCount;
    uint bodyCount;
    uint linkCount;
    uint colliderCount;
    uint contactSlots;              // contacts that one particle can be the first of
    uint cellMask;                  // cells - 1, cells a power of two
    uint cellStrideY;               // lattice grid: cells between neighbours in y ...
    uint cellStrideZ;               // ... and in z
    float diameter;                 // [m]
    float contactRadius;            // candidates are nearer than this [m]
    float inverseCellSize;          // [1/m]
    float drift;                    // a particle that has moved further makes the candidates due again [m]
    float substepTime;              // [s]
    float correction;               // share of a penetration that one substep takes back
    float warmStart;                // share of a normal impulse that an iteration keeps
    float calming;                  // share of what differs from its mean that an iteration takes from it
    float meanRate;                 // share of the way to the impulse that its mean goes in an iteration
    float virtualParticles;         // c of eq. 18
    float freeze;                   // what stays within is calm [m], 0 off
    float damping;                  // velocity kept per substep
    float maxSpeed;                 // [m/s]
    uint secondOrder;               // 1: BDF2 where nothing touches
    uint rotationIterations;
    float maxCorrection;            // of a penetration per substep, with speed [m]
    float jointRelaxation;          // of the joints' impulses
    float overRelaxation;           // the paper's solver: of contacts of bodies
    float stabilization;            // ... of an overlap that stabilization takes back [m]
    float deepOverlap;              // ... that carries nothing [m]
    float deepRecovery;             // ... of a deep overlap that is taken back [m]
    float jointCorrection;          // ... of a joint's gap that draws a body [m]
    uint sharedCount;               // particles of two or more bodies
    uint sharedByTwo;               // of exactly two: the first of sharedParticles
    uint moverCount;                // bodies and loose particles
    uint pairCapacity;              // contacts between particles
    uint colliderPairCapacity;      // contacts with colliders
    float lookAhead;                // of found positions, in moves of a substep
    float farReach;                 // by how much fast movers may look further for contacts [m]
    uint fastLimit;                 // how many particles may do so
    float horizon;                  // for how long contacts should stay good, in substeps
    uint fluidCount;                // fluid particles, which come behind the particleCount others
    uint fluidSlots;                // neighbours that one particle can have in fluids, a multiple of 4
    float fluidSpacing;             // rest distance [m]
    float fluidReach;               // of the smoothing kernel [m]
    float fluidListReach;           // neighbours are listed up to here [m]
    float fluidVolume;              // of a particle, over the volume that the kernel is normalized to [1/m3]
    float fluidSoftness;            // epsilon of Macklin and Mueller 2013, eq. 11 [1/m2]
    float solidCover;               // makes up for solid particles too far to be listed
    float inverseFluidCell;         // [1/m]
    uint fluidCellMask;             // as of the other grid
    uint fluidStrideY;
    uint fluidStrideZ;
    float vorticity;                // strength of vorticity confinement times the step [s]
    float massScaling;              // k of m exp(-k height) [1/m]
    float restitutionThreshold;              // what meets more slowly does not bounce [m/s]
    float sleepSpeed;               // what is slower for long sleeps [m/s]
    uint calmSteps;                 // for how long it has to be calm
    uint assemblyCount;
    uint clusterCount;              // of soft bodies
    uint softCount;                 // particles of soft bodies
    uint substeps;                  // a step
    uint fluidFilled;               // fluid particles that belong to no emitter; they come first
    uint poolCapacity;              // places in the lists of all emitters' pools
    uint drainCount;
};

// Written by kernels, read once a frame. 68 bytes.
struct Counters {
    uint problems;                  // PROBLEM_*
    uint wantedContacts;            // largest number of candidates a particle would have had
    uint wantedColliders;
    uint badParticle;               // one particle that turned NaN
    uint substep;                   // substeps since the start
    uint due;                       // somebody has used up its margin
    uint listParity;                // which half of the candidate lists is current
    uint searchCount;                 // times the candidates were found
    uint pairCount;                 // contacts between particles, touching or about to
    uint colliderPairCount;         // contacts with colliders
    uint wantedPairs;               // what the lists would have had to hold
    uint wantedColliderPairs;
    uint fastCount;                 // particles of movers that will soon leave their margin
    uint fastListed;                // those of them that look further for contacts
    uint fastLater;                 // particles of movers that will leave it in CALM times as long
    uint calm;                      // 1: so few in the last search that contacts are found for as long as that
    uint wantedNeighbours;          // most that a particle would have had in fluids
};

#ifdef __cplusplus
static_assert(sizeof(ParticleRigidBodyLink) == 32 && sizeof(Counters) == 68 && sizeof(GpuCollider) == 96);
}  // namespace knuckle::gpu
#endif
#endif
