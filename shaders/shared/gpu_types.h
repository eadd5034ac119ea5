// Structs that C++ and GLSL share. Only 4-byte scalars and 16-byte vectors, so that both agree on every
// offset (std430 and std140); a test compares them with the driver's.
#ifndef KNUCKLE_GPU_TYPES_H
#define KNUCKLE_GPU_TYPES_H

#include "shared/constants.h"
#include "shared/vector_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
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
struct Particle {
    uint body;                      // first body, NO_INDEX for loose particles
    uint bodyCount;                 // 0 loose, 1 ordinary, 2 or more: a joint
    uint assembly;                  // bodies connected by joints; a loose particle is an assembly of its own
    uint material;
};

// The place of a particle in the order of contact lists: by mover, then by its own index.
struct ParticleRank {
    uint mover;
    uint rank;
};

// What never changes about a body.
struct Body {
    uint linkStart;                 // its block of links; shared particles come last in it
    uint linkCount;
    uint ownCount;                  // links before the first shared particle
    uint jointCount;                // links of shared particles
};

// What never changes about a mover: a body, or a loose particle, which is a body that cannot turn. Bodies come first.
struct Mover {
    uint firstRank;                 // its particles in the order of contact lists
    uint rankCount;
    uint assembly;
    float inverseMass;              // [1/kg], also of movers that do not respond: moverStates tells
};

// A hinge that gears turn. Those of a train follow each other, each behind one that a gear couples it with.
struct GearedHinge {
    uint joint;                     // of the trees
    uint row;                       // of the channel
    uint parentRow;                 // NONE: the other never responds
    uint before;                    // the geared hinge through which it hangs on the train's first; NONE: itself
    float ratio;                    // its turns per turn of the train's first
    uint unused1;
    uint unused2;
    uint unused3;
};

// What never changes about a joint of a tree, or one that closes a loop; its body is the one further from the root.
struct Joint {
    uint body;
    uint parent;                    // NO_INDEX for a root that nothing holds
    uint bodyJoint;                 // the body's own joint in its tree, also for a loop
    uint parentJoint;               // the parent's; NO_INDEX if it never responds
    uint row;                       // of the channel; NO_INDEX for none
    uint parentRow;
    uint firstChild;                // joints that hang on the body, for a tree's joint
    uint childEnd;
};

// The range of a joint.
struct JointRange {
    float swing;                    // of its x axes against each other [rad]; more than half a turn: no limit
    float lowest;                   // turns about x [rad]
    float highest;
    float stiffness;                // [N m/rad], 0: rigid
};

// What never changes about a cluster of a soft body.
struct Cluster {
    uint linkStart;                 // its block of links, after those of all bodies; their rbIndex is the cluster
    uint linkCount;
    uint softBody;
    uint assembly;
};

// Properties of a soft body; moduli over its density.
struct SoftMatter {
    float shear;                    // twice the shear modulus (Lame's mu) [m2/s2]
    float dilation;                 // Lame's lambda [m2/s2]
    float damping;                  // [s]
    float steepest;                 // no force grows by more than this times mass and displacement [1/s2]
    float yield;                    // strain
    float creep;                    // [1/s]
    float maxDeformation;
    float iterations;               // a substep
    float leastEigenvalue;          // of Chebyshev's iterations, over the largest
    float rootCosine;               // of their smallest root
    float unused[2];
};

// What never changes about a collider; colliderPlaces says where it is.
struct Collider {
    vec4 size;                      // box: half extents; sphere, capsule: radius, half height; grids: a cell [m];
                                    // w: COLLIDER_*, as a float
    vec4 friction;                  // static, kinetic; z: 1 for a plane that repeats an earlier one
    vec4 gridLow;                   // where the first value stands [m]
    uvec4 grid;                     // values along x, y, z; the first in gridValues
};

// What never changes about an emitter.
struct Emitter {
    vec4 velocity;                  // of its particles [m/s]; w: fluid nearer than this is in the way [m]
    uvec4 clock;                    // layers before startStep and per step, both 64 bits of 2^-32, low first
    uint startStep;                 // layers leave at the end of this step at the earliest
    uint layerLimit;                // number of layers until it stops
    uint firstPoint;                // in nozzlePoints
    uint pointCount;                // particles of a layer
    uint poolStart;                 // in poolOrder
    uint poolCount;
    uint takesOldest;
    float interval;                 // between layers [s]
};

// State of an emitter in a step.
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

#ifdef __cplusplus
static_assert(sizeof(ParticleRigidBodyLink) == 32 && sizeof(Collider) == 64);
}  // namespace knuckle::gpu
#endif
#endif
