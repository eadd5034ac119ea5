// What draws read and are told, shared by the renderer's host code and shaders.
#ifndef KNUCKLE_DRAW_TYPES_H
#define KNUCKLE_DRAW_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Of a vertex of a skin: place, w: material; normal, w: its first wearer; uv, colour as a number, 0; bodies; weights.
#define SKIN_VERTEX_TEXELS 5

// Of a corner of a mark: place from the centre of its body, w: body; place of the other end of its stroke; how far it
// is moved along the stroke and across it, in heights of the picture; colour, as displayed.
#define MARK_TEXELS 4
// Instead of a body: the place is one on the picture, from its upper left corner, in heights of it.
#define MARK_ON_PICTURE -1.0f

// Which spheres a list has, and how they are drawn from it; each list has draw arguments of its own.
#define SOLID_SPHERES 0
#define FLUID_SPHERES 1
#define POINT_DRAW 0
#define QUAD_DRAW 1
#define SHADOW_DRAW 2
#define DRAWS_PER_GROUP 3
#define SPHERE_DRAWS 6
// Corners of the two triangles of a quad.
#define QUAD_CORNERS 6

// glDrawArraysIndirect's arguments.
struct DrawArguments {
    uint count;
    uint instanceCount;
    uint first;
    uint baseInstance;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
