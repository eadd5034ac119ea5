// The box around an obstacle, whose faces away from the eye start the rays of collider.frag.
#include "render/common/box_corner.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/thing_out.glsl"
#include "render/colliders/collider_place.glsl"
#include "render/colliders/ray_shapes.glsl"

#ifndef FIRST_SHAPE
#define FIRST_SHAPE 0
#endif

uniform samplerBuffer colliderShapes;       // ColliderInstance

flat out vec4 shapePosition;                // w: radius
flat out vec4 shapeOrientation;
flat out vec4 shapeHalfExtents;
flat out vec4 shapeColor;                   // w: shape
flat out uint finishAlpha;
#ifdef PATTERNS
flat out uint patternSeed;
#endif
out vec3 boxPoint;                          // on the box, world space

void main()
{
    int first = 3 * (FIRST_SHAPE + gl_InstanceID);
    shapeHalfExtents = texelFetch(colliderShapes, first);
    shapeColor = texelFetch(colliderShapes, first + 1);
    vec4 collider = texelFetch(colliderShapes, first + 2);
    ColliderPlace place = fetchColliderPlace(collider.x);
    finishAlpha = uint(collider.y);
#ifdef PATTERNS
    patternSeed = uint(collider.x);
#endif
    NAME_THING(collider.x);
    shapePosition = vec4(place.position, shapeHalfExtents.w);
    shapeOrientation = place.orientation;
    vec3 world = shapePosition.xyz + rotate(shapeOrientation, boxCorner(gl_VertexID) * shapeHalfExtents.xyz);
    boxPoint = world;
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(world), 1.0);
#else
    gl_Position = projectView(toView(world));
#endif
}
