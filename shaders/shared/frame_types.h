// Data that the renderer's host code and shaders share. Only 4-byte scalars and 16-byte vectors, all blocks padded to
// whole vectors, so that std140, std430 and C++ agree on every offset; a test compares them with the driver's.
#ifndef KNUCKLE_FRAME_TYPES_H
#define KNUCKLE_FRAME_TYPES_H

#include "shared/gpu_types.h"

#ifdef __cplusplus
namespace knuckle::gpu {
#endif

#define RENDER_GROUP_SIZE 64
// The camera's place: as set, moving with an object, or where it sees all particles from one side or all around.
#define CAMERA_FIXED 0u
#define CAMERA_FOLLOWS 1u
#define CAMERA_FRAMES 2u
#define CAMERA_FRAMES_AROUND 3u
// Or as set, but turned to the middle of what it looks at.
#define CAMERA_LOOKS 4u
// Threads that share the particles for finding their bounds.
#define BOUNDS_THREADS 256
// Cells per side of the grid for finding buried particles.
#define BURIAL_CELLS 32
// The space of a solid particle, counted in integers.
#define SPACE_UNITS 64u
// Radius of fluid particles in their rest distances: they overlap a little, so that still water has no holes.
#define FLUID_RADIUS 0.58f
// The same where a surface is made of them, which must not have holes.
#define SURFACE_RADIUS 0.72f
// Particles that one thread counts and lists, in order: solids or fluids.
#define LIST_CHUNK 64
// Pixels per side of the tiles that the edge filter processes or skips.
#define EDGE_TILE 16

// The one block that the host writes each frame.
struct FrameInput {
    vec4 cameraPosition;        // xyz [m]; CAMERA_FRAMES: only its direction counts. CAMERA_FOLLOWS: from the object;
                                // w: where that waits before it is there, along x [m]
    vec4 cameraTarget;          // xyz [m]; CAMERA_FOLLOWS, w: the same along y, or 0
    vec4 cameraTurn;            // xyz: to the left, up, counter-clockwise, after the camera is aimed [rad]
    vec4 keyDirection;          // xyz towards the light, unit; w: tangent of its angular radius
    vec4 keyColor;              // rgb; w: tolerated error of a skin's level of detail [pixels]
    vec4 skyColor;              // rgb
    vec4 groundColor;           // rgb: light from below; w: exposure
    vec4 groundAlbedo;          // rgb; w: height of the ground [m]
    vec4 backdrop;              // rgb: where nothing is, if that is a colour; w: how far the ground throws light [m]
    vec4 bounce;                // rgb: colour of the ground; w: share of its light that is thrown back
    vec4 shadowLimitLow;        // xyz [m]: only things within these bounds cast shadows
    vec4 shadowLimitHigh;
    vec4 solidLow;              // xyz [m]: bounds of the colliders that cast shadows; low > high for none
    vec4 solidHigh;
    vec4 lens;                  // xy: how far the picture is shifted [NDC]; zw: place on the lens, right and up [m]
    vec4 fog;                   // rgb; w: density at the ground's height [1/m]
    vec4 develop;               // x: share of one draw; y: bloom; z: vignette; w: how fast fog thins upwards [1/m]
    uint width;                 // of the drawn picture, before the resolve [pixels]
    uint height;
    uint particleCount;
    uint cameraMode;            // CAMERA_*
    float radius;               // [m]
    float tanHalfFov;           // vertical
    float farDepth;             // view depth for the depth buffer's 1 [m]
    float pointSizeLimit;       // largest gl_PointSize of the driver [pixels]
    float speedScale;           // from one end of the scale of colours to the other, in its unit
    float shadowSize;           // texels a side of the shadow map
    float occlusionRadius;      // [m]
    float patternScale;         // side of a ground cell [m]
    float groundFade;           // distance at which the ground has mostly become the horizon [m]
    uint followedBodyStart;     // CAMERA_FOLLOWS: bodies of the object
    uint followedBodyCount;
    float trackSeconds;         // since the camera last looked [s]; below 0: it has not looked yet
    uint solidCount;            // particles after these are fluid
    float fluidRadius;          // [m]
    uint fluidSpace;            // over the space of a solid particle, in 1 / SPACE_UNITS
    uint resolveFactor;         // samples an axis of a pixel of the frame
    uint framedBit;             // of framedParticles: those that are framed or looked at; 0: all
    uint cameraPlaneCount;
    float cameraClearance;      // least distance of the camera from each of cameraPlanes [m]
    float frameShare;           // of the picture, that framed things may fill
    float focusDistance;        // along the camera's axis [m]; 0: what it looks at, or those of focusBit
    uint focusBit;              // of framedParticles: those whose middle is sharp; 0: none
    uint cameraSolidCount;
    float boundsMargin;         // how far drawn things stand out from their particles' spheres at most [m]
};

// A moment between two steps.
struct BetweenInput {
    float part;                 // of the step
    float timeStep;             // [s]
    uint particleCount;
    uint bodyCount;
    uint colliderCount;
    uint foamCount;
    uint unused0;
    uint unused1;
};

// Results of one thread of frame_bounds.comp.
struct ParticleBounds {
    vec4 low;                   // xyz [m]
    vec4 high;
    vec4 sum;                   // xyz [m]: of positions from the middle of the shadow limits; w: their number
    vec4 squares;               // xyz [m2]
    vec4 framedLow;             // xyz [m]: of those of FrameInput::framedBit
    vec4 framedHigh;
    vec4 framedMost;            // of the same: x + y + z, -x + y + z, x - y + z, x + y - z [m]
    vec4 framedLeast;
    vec4 focusLow;              // xyz [m]: of those of FrameInput::focusBit
    vec4 focusHigh;
};

// Values that frame_camera.comp and frame_view.comp compute from both on the GPU.
struct FrameView {
    vec4 cameraRight;           // xyz; w: how far the picture is shifted to the right [NDC]
    vec4 cameraUp;              // xyz; w: the same upwards
    vec4 cameraBack;            // xyz; w: distance of what is sharp [m]; kept from frame to frame
    vec4 cameraPosition;
    vec4 lightRight;            // axes of the shadow map's view, world space
    vec4 lightUp;
    vec4 lightCentre;           // xyz; w: half the side of the square it covers [m]
    vec4 lightDepth;            // x: half the depth range [m]; yzw: the middle of the camera's lens
    vec4 cellOrigin;            // xyz [m]: lowest corner of the burial grid
    vec4 cellSize;              // xyz [m]; w: space of particles from which on a cell counts as full
    vec4 viewToLightX;          // light clip coordinates from view space: dot(xyz, p) + w
    vec4 viewToLightY;
    vec4 viewToLightZ;
    vec4 keyInView;             // xyz: keyDirection in view space
    vec4 upInView;              // xyz: +Y in view space
    vec4 shadedInLight;         // shadow map coordinates (left, bottom, right, top): the ground outside is not shaded
    vec4 particleLow;           // xyz [m]: bounds of the particles' centres
    vec4 particleHigh;
    vec4 trackedLow;            // xyz [m]: what the camera shows or follows, smoothed; kept from frame to frame. Of
                                // named particles: where it aims, w: its distance from there [m]
    vec4 trackedHigh;           // w: how far the camera is turned around what would hide that [rad]
};

// A collider with an inside, which holds off cameras that move by themselves.
struct CameraSolid {
    vec4 extents;               // xyz [m]: half the box that it is around, which has no size in a ball; w: radius [m]
    vec4 low;                   // xyz [m]: of its grid; w: index of the collider
    vec4 cell;                  // xyz [m]; w: COLLIDER_*
    uvec4 grid;                 // xyz: values on each axis; w: the first of them in cameraGrids
};

// An obstacle as an instance attribute block; colliderPlaces says where it is.
struct ColliderInstance {
    vec4 halfExtents;           // xyz [m]: of the box, or of the box around the shape in its own frame; w: radius [m]
    vec4 color;                 // rgb; w: shape (COLLIDER_*)
    vec4 collider;              // x: its index; y: its finish
};

#ifdef __cplusplus
}  // namespace knuckle::gpu
#endif
#endif
