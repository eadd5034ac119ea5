// The pixel's ray against a body's shape: depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/shapes/ray_rounded.glsl"

flat in vec4 rounded;
flat in vec4 source;
flat in mat3 toShape;
layout(location = 0) out uvec2 surface;
layout(depth_greater) out float gl_FragDepth;

void main()
{
    vec3 normal;
    float depth = rayRounded(source.xyz, toShape * viewRay(gl_FragCoord.xy), rounded.xyz, rounded.w, normal);
    if (depth <= 0.0) discard;
    surface = uvec2(packNormal(normal * toShape), packRoots(unpackRoots(uint(source.w)), 1.0));
    gl_FragDepth = depth / frame.farDepth;
}
