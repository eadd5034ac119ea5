// The box around an obstacle, whose faces away from the eye start the rays of collider.frag.
#include "render/common/frame_blocks.glsl"
#include "render/colliders/collider_place.glsl"
#include "render/colliders/ray_shapes.glsl"

uniform samplerBuffer colliderShapes;       // ColliderInstance

flat out vec4 shapePosition;                // w: radius
flat out vec4 shapeOrientation;
flat out vec4 shapeHalfExtents;
flat out vec4 shapeColor;                   // w: shape
out vec3 boxPoint;                          // on the box, world space

void main()
{
    int first = 3 * gl_InstanceID;
    shapeHalfExtents = texelFetch(colliderShapes, first);
    shapeColor = texelFetch(colliderShapes, first + 1);
    ColliderPlace place = fetchColliderPlace(texelFetch(colliderShapes, first + 2).x);
    shapePosition = vec4(place.position, shapeHalfExtents.w);
    shapeOrientation = place.orientation;
    // A cube's 14-vertex strip, one bit per axis and vertex.
    vec3 corner = vec3(uvec3(0x287au, 0x02afu, 0x31e3u) >> gl_VertexID & 1u) * 2.0 - 1.0;
    vec3 world = shapePosition.xyz + rotate(shapeOrientation, corner * shapeHalfExtents.xyz);
    boxPoint = world;
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(world), 1.0);
#else
    gl_Position = projectView(toView(world));
#endif
}
