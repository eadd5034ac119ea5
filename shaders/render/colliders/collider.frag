// The pixel's ray against one obstacle: depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/colliders/ray_shapes.glsl"

flat in vec4 shapePosition;
flat in vec4 shapeOrientation;
flat in vec4 shapeHalfExtents;
flat in vec4 shapeColor;
in vec3 boxPoint;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 ray = directionToWorld(viewRay(gl_FragCoord.xy));
    vec3 origin = rotateBack(shapeOrientation, view.cameraPosition.xyz - shapePosition.xyz);
    vec3 normal;
    float depth = rayShape(uint(shapeColor.w), origin, rotateBack(shapeOrientation, ray), shapeHalfExtents.xyz,
                           shapePosition.w, normal);
    if (depth <= 0.0) discard;
    surface = uvec2(packNormal(directionToView(rotate(shapeOrientation, normal))),
                    packAlbedo(shapeColor.rgb, 1.0));
    gl_FragDepth = depth / frame.farDepth;
}
