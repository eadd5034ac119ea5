// The light's ray against one obstacle: its depth in the shadow map.
#include "render/common/frame_blocks.glsl"
#include "render/colliders/ray_shapes.glsl"

flat in vec4 shapePosition;
flat in vec4 shapeOrientation;
flat in vec4 shapeHalfExtents;
flat in vec4 shapeColor;
in vec3 boxPoint;

void main()
{
#ifdef GLASS
    // A quarter of the light is kept, which smooths out in the shadow.
    if (((int(gl_FragCoord.x) | int(gl_FragCoord.y)) & 1) != 0) discard;
#endif
    // Starts far outside: the obstacle may extend beyond the map's depth.
    float reach = 2.0 * length(shapeHalfExtents.xyz);
    vec3 start = boxPoint + reach * frame.keyDirection.xyz;
    vec3 origin = rotateBack(shapeOrientation, start - shapePosition.xyz);
    vec3 normal;
    float along = rayShape(uint(shapeColor.w), origin, rotateBack(shapeOrientation, -frame.keyDirection.xyz),
                           shapeHalfExtents.xyz, shapePosition.w, normal);
    if (along < 0.0) discard;
    gl_FragDepth = clamp(0.5 * worldToLight(start - along * frame.keyDirection.xyz).z + 0.5, 0.0, 1.0);
}
