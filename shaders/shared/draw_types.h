// What draws read and are told, shared by the renderer's host code and shaders.
#ifndef KNUCKLE_DRAW_TYPES_H
#define KNUCKLE_DRAW_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Vertices of a wearer's skin that a group of threads poses, each some of them; a wearer's begin with a group of their
// own.
#define SKIN_GROUP_SIZE 512u
// Texels of the shadow map that the surface of a level of detail may be off for each pixel of the picture.
#define SKIN_TEXELS_A_PIXEL 1.5f

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

// glDrawElementsIndirect's arguments.
struct DrawElementsArguments {
    uint count;
    uint instanceCount;
    uint firstIndex;
    uint baseVertex;
    uint baseInstance;
};

// What of a vertex of a skin moves. Bodies are those within the object, heaviest first.
struct SkinVertex {
    float placeX;               // in the rest pose of its object [m]
    float placeY;
    float placeZ;
    uint normalXY;              // 16 bits each, as packSnorm2x16() has them
    uint bodies01;              // 16 bits each
    uint bodies23;
    uint weights12;             // as packUnorm2x16() has them; the first body has what the others leave of 1
    uint normalZWeight3;
};

// A level of detail, from the finest to the coarsest.
struct SkinLod {
    uint firstIndex;
    uint indexCount;
    uint vertexCount;           // it uses the first so many vertices of the skin
    float error;                // [m]
};

// An object in its skin.
struct SkinWearer {
    uint firstBody;
    uint bodyCount;
    uint firstPlace;            // of its vertices, where they are now; whole groups
    uint firstLod;
    uint lodCount;
    uint unused0;
    uint unused1;
    uint unused2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
