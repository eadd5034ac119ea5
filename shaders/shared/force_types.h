// The host's data for the room `forces`. Four-byte scalars and sixteen-byte vectors, as in gpu_types.h.
#ifndef KNUCKLE_FORCE_TYPES_H
#define KNUCKLE_FORCE_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// FieldKind and FieldFalloff of sim/world/forces/forces.h.
#define FIELD_PULL 0u
#define FIELD_PUSH 1u
#define FIELD_SWIRL 2u
#define FIELD_BLOW 3u
#define FALLOFF_NONE 0u
#define FALLOFF_LINEAR 1u

// An inverse square does not grow further below this distance [m].
#define FIELD_NEAREST 0.05
// Drag coefficients over the area seen in the direction of motion (Hoerner 1965, "Fluid-dynamic drag", chapter 3): of a
// sphere, a cube, a cylinder across its axis, a plate across the motion and along it.
#define SPHERE_DRAG 0.47
#define BLOCK_DRAG 1.05
#define ROPE_DRAG 1.1
#define PLATE_DRAG 1.2
#define SKIN_DRAG 0.04
// Densities around fluid particles, over that at rest, at which the air reaches them from all sides, and hardly any
// more.
#define ALONE_DENSITY 0.3
#define SURFACE_DENSITY 0.9

struct ForceField {
    vec4 place;   // xyz its middle [m], w its strength [m/s2], of FIELD_BLOW [m/s]
    vec4 turn;    // quaternion
    vec4 size;    // box: half extents; else radius and half height [m]; w how far it reaches from its middle [m]
    uvec4 kind;   // ColliderShape, FIELD_*, FALLOFF_*
    vec4 times;   // from, until [s]
};

struct GustWave {
    vec4 wave;        // xyz [rad/m], w phase [rad]
    vec4 amplitude;   // xyz [m/s], w rate [rad/s] at a fixed place
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
