// The box around an obstacle, whose faces away from the eye start the rays of collider.frag.
#include "render/common/frame_blocks.glsl"
#include "render/colliders/ray_shapes.glsl"

layout(location = 0) in vec4 position;      // w: radius
layout(location = 1) in vec4 orientation;
layout(location = 2) in vec4 halfExtents;
layout(location = 3) in vec4 color;         // w: shape

flat out vec4 shapePosition;
flat out vec4 shapeOrientation;
flat out vec4 shapeHalfExtents;
flat out vec4 shapeColor;
out vec3 boxPoint;                          // on the box, world space

void main()
{
    // A cube's 14-vertex strip, one bit per axis and vertex.
    vec3 corner = vec3(uvec3(0x287au, 0x02afu, 0x31e3u) >> gl_VertexID & 1u) * 2.0 - 1.0;
    vec3 world = position.xyz + rotate(orientation, corner * halfExtents.xyz);
    shapePosition = position;
    shapeOrientation = orientation;
    shapeHalfExtents = halfExtents;
    shapeColor = color;
    boxPoint = world;
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(world), 1.0);
#else
    gl_Position = projectView(toView(world));
#endif
}
