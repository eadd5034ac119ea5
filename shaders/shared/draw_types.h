// Inputs of draws, shared by the renderer's host code and shaders.
#ifndef KNUCKLE_DRAW_TYPES_H
#define KNUCKLE_DRAW_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Vertices of a wearer's skin that a group of threads poses, each several of them; each wearer starts a new group.
#define SKIN_GROUP_SIZE 512u
// Per material of a skin: alpha cutoff, bits: two-sided, wrap of u and v, the first level of its picture, levels; those
// of its normals, their scale; those of its roughnesses, factors of roughness and metalness.
#define SKIN_MATERIAL_TEXELS 3
// Steps of roughness that are told apart where a picture has it.
#define ROUGHNESS_STEPS 16
// Tolerated error of a level of detail in texels of the shadow map, per pixel of the tolerance in the picture.
#define SKIN_TEXELS_A_PIXEL 1.5f

// Per corner of a mark: place from the centre of its body, w: body; place of the other end of its stroke; shift along
// the stroke and across it, in heights of the picture; colour, as displayed.
#define MARK_TEXELS 4
// In place of a body: the place is on the picture, from its upper left corner, in heights of the picture.
#define MARK_ON_PICTURE -1.0f

// Per finish: roughness, metalness, coat, wrap; diffuse roughness, reflectance, pattern, its size [m]; emission. The
// first is the ground's.
#define FINISH_TEXELS 3
// In place of the alpha of a surface's colour: no finish. 0 is the ground.
#define FINISH_NONE 255u
// What a plane shows, in the order of FloorLook.
#define FLOOR_DEFAULT 0u
#define FLOOR_STUDIO 1u
#define FLOOR_TILES 2u
#define FLOOR_CHECKER 3u
#define FLOOR_WOOD 4u
#define FLOOR_GRASS 5u
#define FLOOR_GRID 6u
#define FLOOR_MIRROR 7u
// Maps of what rougher and rougher surfaces mirror of a sky.
#define SKY_BLURS 4
#define PATTERN_NONE 0u
#define PATTERN_WOOD 1u
#define PATTERN_CHECKER 2u
#define PATTERN_BRUSHED 3u

// Vertices of a strip of triangles around a box.
#define BOX_STRIP 14
// Per shape of a body: half sides of its box, radius around it; its middle from the body's mass centre at rest, w: the
// body; colour, two particles whose mean moves as the middle does, finish.
#define SHAPE_TEXELS 3

// Spheres of a list, and how they are drawn from it; each list has its own draw arguments.
#define SOLID_SPHERES 0
#define FLUID_SPHERES 1
#define POINT_DRAW 0
#define QUAD_DRAW 1
#define SHADOW_DRAW 2
#define DRAWS_PER_GROUP 3
#define SPHERE_DRAWS 6
// Instead of a quantity that a particle does not have, and the light that its colour then throws back.
#define NO_QUANTITY -1e30f
#define NO_QUANTITY_GREY 0.33f
// Instead of the material of a fluid particle that is drawn as a sphere.
#define NO_SURFACE 0xffffffffu
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

// The data of a skin's vertex for moving it. Bodies are those within the object, heaviest first.
struct SkinVertex {
    float placeX;               // in the rest pose of its object [m]
    float placeY;
    float placeZ;
    uint normalXY;              // 16 bits each, in the format of packSnorm2x16()
    uint bodies01;              // 16 bits each
    uint bodies23;
    uint weights12;             // in the format of packUnorm2x16(); the first body has the rest of 1
    uint normalZWeight3;
};

// A level of detail, from the finest to the coarsest.
struct SkinLod {
    uint firstIndex;
    uint indexCount;
    uint vertexCount;           // it uses this many of the skin's vertices, from the first on
    float error;                // [m]
};

// An object in its skin.
struct SkinWearer {
    uint firstBody;
    uint bodyCount;
    uint firstPlace;            // of its vertices' current places; whole groups
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
