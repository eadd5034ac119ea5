// The pixel's ray against a body's shape: depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/shapes/ray_rounded.glsl"

flat in vec4 rounded;
flat in vec3 source;
flat in mat3 toShape;
flat in uint colorWord;
in vec3 boxPoint;
in float boxDepth;
layout(location = 0) out uvec2 surface;
layout(depth_greater) out float gl_FragDepth;

void main()
{
    vec3 normal;
    float depth = rayRounded(source, toShape * viewRay(gl_FragCoord.xy), rounded.xyz, rounded.w, normal);
    if (depth <= 0.0) discard;
    surface = uvec2(packNormal(normal * toShape), colorWord);
    gl_FragDepth = depth / frame.farDepth;
}
