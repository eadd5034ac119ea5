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
    vec4 inertia;                   // of what turns about it, in its body's axes: diagonal [kg m2]; w: greatest torque
    vec4 inertiaBeside;             // xy, xz, yz; w: 1 of a hinge, which turns about `axis` alone
    vec4 axis;                      // xyz, in its body's axes
    float stiffness;                // times inertia [1/s2]
    float damping;                  // times inertia [1/s]
    uint body;                      // among animated bodies
    uint joint;                     // of the trees
    uint row;                       // of the channel
    uint parentRow;
    uint unused1;
    uint unused2;
};

// What holds a body where its clip has it in the world.
struct GpuPin {
    vec4 inertia;                   // that it holds, in the body's axes: diagonal [kg m2]; w: greatest torque [N m]
    vec4 inertiaBeside;             // xy, xz, yz; w: mass that it holds [kg]
    float stiffness;                // times mass or inertia [1/s2]
    float damping;                  // times mass or inertia [1/s]
    float greatestForce;            // [N]
    uint body;                      // among animated bodies
    uint joint;                     // of the trees, that of the body
    uint row;                       // of the channel
    uint unused1;
    uint unused2;
};

// An animated object that is driven.
struct GpuPuppet {
    uint firstBody;                 // among animated bodies
    uint bodyCount;
    uint firstKey;                  // of its strength
    uint keyCount;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
