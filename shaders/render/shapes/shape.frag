// The pixel's ray against a body's shape: depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#include "render/shapes/ray_rounded.glsl"
#ifdef PATTERNS
#include "render/common/finish_pattern.glsl"

flat in uint patternSeed;
#endif

flat in vec4 rounded;
flat in vec4 source;
flat in mat3 toShape;
flat in uint finishAlpha;
layout(location = 0) out uvec2 surface;
layout(depth_greater) out float gl_FragDepth;

void main()
{
    vec3 normal;
    vec3 ray = toShape * viewRay(gl_FragCoord.xy);
    float depth = rayRounded(source.xyz, ray, rounded.xyz, rounded.w, normal);
    if (depth <= 0.0) discard;
    uint word = uint(source.w) | finishAlpha << 24;
#ifdef PATTERNS
    word = patternedWord(word, alongAxis(source.xyz + depth * ray, longestOf(rounded.xyz)), patternSeed,
                         pixelWidth(depth, normal * toShape));
#endif
    surface = uvec2(packNormal(normal * toShape), word);
    gl_FragDepth = depth / frame.farDepth;
    SHOW_THING(THING_BODY);
}
