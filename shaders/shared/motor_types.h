// Motors and springs of joints, for C++ and GLSL; as in gpu_types.h, of four-byte scalars and sixteen-byte vectors.
#ifndef KNUCKLE_MOTOR_TYPES_H
#define KNUCKLE_MOTOR_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Texels of 16 bytes of a motor's state.
#define MOTOR_STATE_TEXELS 2

// A motor or a spring of a joint between any bodies, seen from its body in the tree.
struct Motor {
    vec4 frame;                     // from the joint's axes to those of its body; a hinge turns about x
    vec4 parentFrame;               // and to those of the other, as it starts
    float stiffness;                // [N m/rad]
    float damping;                  // [N m s/rad]
    float angle;                    // at rest [rad]
    float speed;                    // at which it does not damp [rad/s]
    float greatestTorque;           // [N m]
    float reach;                    // from further away it pulls as from here [rad]
    uint isHinge;                   // 1: about x only, 0: about all axes
    uint keepsAwake;                // 1: what it turns does not sleep
    uint body;
    uint parent;
    uint joint;                     // of the trees
    uint row;                       // of the channel
    uint parentRow;                 // NONE: the other never responds
    uint unused1;
    uint unused2;
    uint unused3;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
