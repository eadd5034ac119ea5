// Structs of drives that C++ and GLSL share; as in gpu_types.h, of scalars of four bytes and vectors of sixteen.
#ifndef KNUCKLE_DRIVE_TYPES_H
#define KNUCKLE_DRIVE_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Texels of 16 bytes of what changes about a driven joint and a pin, and of what both add to a joint's block.
#define DRIVE_STATE_TEXELS 3
#define PIN_STATE_TEXELS 6
#define PIN_GIVEN_TEXELS 3
#define DRIVE_STIFFNESS_TEXELS 4

// A joint that is driven to a clip.
struct GpuJointDrive {
    vec4 axis;                      // xyz: of a hinge, in its body's axes; w: 1 of a hinge, else 0
    float stiffness;                // times the inertia that it turns [1/s2], or by itself [N m/rad]
    float damping;                  // the same [1/s], [N m s/rad]
    uint isGiven;                   // 1: by itself
    float greatestTorque;           // [N m]
    uint body;                      // among animated bodies
    uint joint;                     // of the trees
    uint row;                       // of the channel
    uint parentRow;
};

// What holds a body where its clip has it in the world.
struct GpuPin {
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
struct GpuPuppet {
    uint firstBody;                 // among animated bodies
    uint bodyCount;
    uint firstKey;                  // of its strength
    uint keyCount;
    uint isHeld;                    // 1: by something that is fixed for ever
    uint unused1;
    uint unused2;
    uint unused3;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
