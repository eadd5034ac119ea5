// Structs of drives that C++ and GLSL share; as in gpu_types.h, of four-byte scalars and sixteen-byte vectors.
#ifndef KNUCKLE_DRIVE_TYPES_H
#define KNUCKLE_DRIVE_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Texels of 16 bytes of the state of a driven joint and of a pin, and of the stiffness that both add to a joint's
// block.
#define DRIVE_STATE_TEXELS 4
#define PIN_STATE_TEXELS 6
#define PIN_GIVEN_TEXELS 3
#define DRIVE_STIFFNESS_TEXELS 4

// Phases of a puppet.
#define PUPPET_FIRST 0u       // at first, until it is caught
#define PUPPET_FOUND 1u       // for one substep, in which the clip that catches it begins
#define PUPPET_CATCHING 2u    // driven to its clip, to be animated again
#define PUPPET_CAUGHT 3u      // animated again
#define PUPPET_MISSED 4u      // it did not get near enough

// What happens then.
#define OTHERWISE_LIMP 0u
#define OTHERWISE_DRIVEN 1u
#define OTHERWISE_ANIMATED 2u

#define CATCH_SETTLE 0.3      // time in which it moves on to its clip, once it is near [s]

// A joint that is driven to a clip.
struct JointDrive {
    vec4 axis;                      // xyz: of a hinge, in its body's axes; w: 1 of a hinge, else 0
    float stiffness;                // times the inertia that it turns [1/s2], or absolute [N m/rad]
    float damping;                  // the same [1/s], [N m s/rad]
    uint isGiven;                   // 1: absolute
    float greatestTorque;           // [N m]
    uint body;                      // among animated bodies
    uint joint;                     // of the trees
    uint row;                       // of the channel
    uint parentRow;
    uint puppet;
    uint unused1;
    uint unused2;
    uint unused3;
};

// Holds a body at its clip's place in the world.
struct Pin {
    float stiffness;                // times the mass or inertia that it holds [1/s2]
    float damping;                  // the same [1/s]
    float greatestForce;            // [N]
    float greatestTorque;           // [N m]
    uint body;                      // among animated bodies
    uint joint;                     // of the trees, that of the body
    uint row;                       // of the channel
    uint unused1;
};

// An animated object that is driven.
struct Puppet {
    uint firstBody;                 // among animated bodies
    uint bodyCount;
    uint firstKey;                  // of its strength
    uint keyCount;
    uint isHeld;                    // 1: something that is fixed for ever holds it
    float mass;                     // [kg]
    float hitImpulse;               // of a blow that takes all strength [N s]
    float hitFalloff;               // of that, from joint to joint
    float hitHold;                  // time for which it stays away [s]
    float hitRecover;               // and in which it comes back [s]
    float knockDistance;            // from the clip, at which it is let go [m]
    float knockTime;                // time at a greatest torque after which it is let go [s]
    uint catchSubstep;              // in which it begins to be caught; NO_SUBSTEP: never
    uint catchHere;                 // 1: at its own place then, 0: at its clip's
    uint catchOtherwise;            // OTHERWISE_*
    float catchBlend;               // time in which strength grows [s]
    float catchNear;                // distance that is near enough [m]
    float catchWithin;              // time for which it is tried [s]
    uint unused1;
    uint unused2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
