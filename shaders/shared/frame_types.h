// What the renderer's host code and shaders share. Only 4-byte scalars and 16-byte vectors, all blocks padded to whole
// vectors, so that std140, std430 and C++ agree on every offset; a test compares them with the driver's.
#ifndef KNUCKLE_FRAME_TYPES_H
#define KNUCKLE_FRAME_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

// Uniform blocks.
#define FRAME_INPUT_SLOT 0
#define FRAME_VIEW_SLOT 1
// Storage buffers of the renderer's kernels.
#define RENDER_POSITIONS_SLOT 0
#define RENDER_CENTRES_SLOT 1
#define RENDER_BOUNDS_SLOT 2
#define RENDER_VIEW_SLOT 3
#define RENDER_VISIBLE_SLOT 4
#define RENDER_COUNTS_SLOT 5
#define RENDER_LIST_SLOT 6
#define RENDER_DRAWS_SLOT 7
// Once frame_view is done with its inputs (OpenGL 4.3 promises only eight).
#define RENDER_CELLS_SLOT 1
#define RENDER_BURIED_SLOT 2
// Texture units.
#define DEPTH_UNIT 0
#define SURFACE_UNIT 1
#define SHADOW_UNIT 2
#define SHADE_UNIT 3
#define PICTURE_UNIT 4
#define POSITIONS_UNIT 6
#define COLORS_UNIT 7
#define VELOCITIES_UNIT 8
// Vertex attributes.
#define POSITION_ATTRIBUTE 0
#define INDEX_ATTRIBUTE 0

#define RENDER_GROUP_SIZE 64
// Where the camera is: as told, moving with an object, or where it sees all particles from one side or all around.
#define CAMERA_FIXED 0u
#define CAMERA_FOLLOWS 1u
#define CAMERA_FRAMES 2u
#define CAMERA_FRAMES_AROUND 3u
// Threads that share the particles when their bounds are sought.
#define BOUNDS_THREADS 256
// Cells a side of the grid in which buried particles are found.
#define BURIAL_CELLS 32
// The space that a particle takes, to be counted in integers.
#define SPACE_UNITS 64u
// Radius of fluid particles in their rest distances: they overlap a little, so that still water has no holes.
#define FLUID_RADIUS 0.58f
// Particles that one thread counts and lists, in order.
#define LIST_CHUNK 64
// Pixels a side of the tiles that the edge filter takes or leaves.
#define EDGE_TILE 16

// Shapes, as in ColliderShape.
#define SHAPE_PLANE 0u
#define SHAPE_BOX 1u
#define SHAPE_SPHERE 2u
#define SHAPE_CAPSULE 3u

// The one block that the host writes each frame.
struct FrameInput {
    vec4 cameraPosition;        // xyz [m]; CAMERA_FOLLOWS: from the object; CAMERA_FRAMES: only its direction counts
    vec4 cameraTarget;          // xyz [m]
    vec4 keyDirection;          // xyz towards the light, unit; w: tangent of its angular radius
    vec4 keyColor;              // rgb
    vec4 skyColor;              // rgb
    vec4 groundColor;           // rgb: light from below; w: exposure
    vec4 groundAlbedo;          // rgb; w: height of the ground [m]
    vec4 shadowLimitLow;        // xyz [m]: shadows are cast within these bounds at most
    vec4 shadowLimitHigh;
    vec4 solidLow;              // xyz [m]: bounds of the colliders that cast shadows; low > high for none
    vec4 solidHigh;
    uint width;                 // of the picture as drawn, before the resolve [pixels]
    uint height;
    uint particleCount;
    uint cameraMode;            // CAMERA_*
    float radius;               // [m]
    float tanHalfFov;           // vertical
    float farDepth;             // view depth that the depth buffer's 1 stands for [m]
    float pointSizeLimit;       // largest gl_PointSize of the driver [pixels]
    float speedScale;           // [m/s]
    float shadowSize;           // texels a side of the shadow map
    float occlusionRadius;      // [m]
    float patternScale;         // side of a ground cell [m]
    float groundFade;           // distance at which the ground has mostly become the horizon [m]
    uint followedBodyStart;     // CAMERA_FOLLOWS: bodies of the object
    uint followedBodyCount;
    float trackSeconds;         // since the camera last looked [s]; below 0: it has not looked yet
    uint solidCount;            // those behind the first so many particles are fluid
    float fluidRadius;          // [m]
    uint fluidShare;            // of the space that a solid particle takes, in 1 / SPACE_UNITS
    uint unused;
};

// What one thread of frame_bounds.comp finds.
struct ParticleBounds {
    vec4 low;                   // xyz [m]
    vec4 high;
    vec4 sum;                   // xyz [m]: of positions from the middle of the shadow limits; w: how many there are
    vec4 squares;               // xyz [m2]
};

// What frame_camera.comp and frame_view.comp derive from both on the GPU.
struct FrameView {
    vec4 cameraRight;           // xyz; w unused
    vec4 cameraUp;
    vec4 cameraBack;
    vec4 cameraPosition;
    vec4 lightRight;            // axes of the shadow map's view, world space
    vec4 lightUp;
    vec4 lightCentre;           // xyz; w: half the side of the square it covers [m]
    vec4 lightDepth;            // x: half the depth range [m]
    vec4 cellOrigin;            // xyz [m]: lowest corner of the burial grid
    vec4 cellSize;              // xyz [m]; w: what particles take of a cell that counts as full
    vec4 viewToLightX;          // light clip coordinates from view space: dot(xyz, p) + w
    vec4 viewToLightY;
    vec4 viewToLightZ;
    vec4 keyInView;             // xyz: keyDirection in view space
    vec4 upInView;              // xyz: +Y in view space
    vec4 shadedInLight;         // shadow map coordinates (left, bottom, right, top): outside nothing shades the ground
    vec4 particleLow;           // xyz [m]: bounds of the particles' centres
    vec4 particleHigh;
    vec4 trackedLow;            // xyz [m]: what the camera shows or follows, smoothed; kept from frame to frame
    vec4 trackedHigh;
};

// An immovable obstacle as an instance attribute block.
struct ColliderInstance {
    vec4 position;              // xyz [m]; w: radius [m]
    vec4 orientation;           // quaternion xyzw
    vec4 halfExtents;           // xyz [m]: of the box, or of the box around the shape in its own frame
    vec4 color;                 // rgb; w: shape (SHAPE_*)
};

// Places of the draw arguments.
#define POINT_DRAW 0
#define QUAD_DRAW 1
#define SHADOW_DRAW 2
#define DRAW_COUNT 3

// glDrawElementsIndirect's arguments (and with `first` glDrawArraysIndirect's, whose layout is a prefix's).
struct DrawArguments {
    uint count;
    uint instanceCount;
    uint firstIndex;
    uint baseVertex;
    uint baseInstance;
    uint pad0;
    uint pad1;
    uint pad2;
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
