// Structs of animations that C++ and GLSL share; as in gpu_types.h, of scalars of four bytes and vectors of sixteen.
#ifndef KNUCKLE_ANIMATION_TYPES_H
#define KNUCKLE_ANIMATION_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// A body that a clip moves.
struct AnimatedBody {
    uint mover;
    uint parent;                    // among these; NO_INDEX of the first of its object
    uint animation;
    uint turn;                      // its place in a key
    vec4 centre;                    // xyz: its mass centre at rest [m]
    vec4 anchor;                    // xyz: its joint, or the pivot, at rest
};

// A collider that a clip moves.
struct MovingCollider {
    uint collider;
    uint animation;                 // of the frame that it stands in
    float reach;                    // from its place to its farthest point [m]
    uint unused0;
    vec4 position;                  // xyz: in that frame [m]
    vec4 orientation;
};

struct Animation {
    vec4 position;                  // xyz: of the object's rest pose in the world [m]
    vec4 rotation;
    uint firstPlay;
    uint playCount;
    uint puppet;                    // NO_INDEX where it is never driven
    uint unused1;
};

// A clip as it is played.
struct ClipPlay {
    uint firstTurn;                 // of its first key, among all clips' turns
    uint firstRoot;
    uint keyCount;
    uint bodyCount;
    float at;                       // when it begins [s]
    float firstKey;                 // where
    float keyRate;                  // keys a second, at its speed
    float fade;                     // [s]
    uint loop;
    uint inPlace;
    float yaw;                      // turn about y that it is put with [rad]
    float roundYaw;                 // and that each round adds; 0: roundShift is a shift
    vec4 shift;                     // xyz [m]
    vec4 roundShift;                // xyz: of a round, or the point that it turns about [m]
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
