// Structs of animations that C++ and GLSL share; as in gpu_types.h, of four-byte scalars and sixteen-byte vectors.
#ifndef KNUCKLE_ANIMATION_TYPES_H
#define KNUCKLE_ANIMATION_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// A body that a clip moves.
struct AnimatedBody {
    uint mover;
    uint parent;                    // among these; NO_INDEX for the first of its object
    uint animation;
    uint turn;                      // its place in a key
    vec4 centre;                    // xyz: its mass centre at rest [m]
    vec4 anchor;                    // xyz: its joint, or the pivot, at rest
};

// A collider that a clip moves.
struct MovingCollider {
    uint collider;
    uint animation;                 // of its frame
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
    uint puppet;                    // NO_INDEX if it is never driven
    uint unused1;
};

// A play of a clip.
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
    float yaw;                      // its turn about y [rad]
    float roundYaw;                 // and that of each round; 0: roundShift is a shift
    vec4 shift;                     // xyz [m]
    vec4 roundShift;                // xyz: shift of a round, or the point that it turns about [m]
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
