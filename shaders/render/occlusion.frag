// Half resolution: how much of the ambient light (x) and of the key light (y) reaches the surface, and its depth (z).
#include "shared/frame_blocks.glsl"
#include "shared/surface.glsl"

layout(binding = DEPTH_UNIT) uniform sampler2D depthPicture;
layout(binding = SURFACE_UNIT) uniform usampler2D surfacePicture;
layout(binding = SHADOW_UNIT) uniform sampler2D shadowDepth;
layout(location = 0) out vec4 shade;

const int OCCLUSION_TAPS = 9;
const int BLOCKER_TAPS = 6;
const int SHADOW_TAPS = 8;
const float MAX_OCCLUSION_PIXELS = 110.0;
// Share of a texel that a surface is lifted before it looks for the light, so that it does not shade itself.
const float LIFT_TEXELS = 1.5;

// A Vogel spiral: `count` points spread evenly over the unit disc.
vec2 spiral(int i, int count)
{
    float turn = float(i) * 2.399963;
    return sqrt((float(i) + 0.5) / float(count)) * vec2(cos(turn), sin(turn));
}

// Ambient obscurance (McGuire et al. 2011, "The Alchemy Screen-Space Ambient Obscurance Algorithm", eq. 10, with the
// falloff of "Scalable Ambient Obscurance", 2012).
float ambientReach(ivec2 pixel, vec3 p, vec3 n, mat2 turn)
{
    float radius = frame.occlusionRadius;
    float pixels = min(radius * float(frame.height) / (2.0 * frame.tanHalfFov * -p.z), MAX_OCCLUSION_PIXELS);
    float sum = 0.0;
    for (int i = 0; i < OCCLUSION_TAPS; ++i) {
        vec2 unit = spiral(i, OCCLUSION_TAPS);
        ivec2 tap = clamp(pixel + ivec2(turn * (unit * length(unit)) * pixels), ivec2(0),
                          ivec2(frame.width, frame.height) - 1);
        vec3 v = viewRay(vec2(tap) + 0.5) * (texelFetch(depthPicture, tap, 0).r * frame.farDepth) - p;
        float square = dot(v, v);
        float fade = max(1.0 - square / (radius * radius), 0.0);
        sum += fade * fade * max(dot(v, n) - 0.002 * -p.z, 0.0) / (square + 0.01 * radius * radius) * radius;
    }
    return clamp(1.0 - 0.55 * sum / float(OCCLUSION_TAPS), 0.0, 1.0);
}

// Percentage-closer soft shadows (Fernando 2005).
float keyReach(vec3 p, vec3 n, mat2 turn)
{
    float texel = 2.0 * view.lightCentre.w / frame.shadowSize;
    vec3 place = viewToLight(p + n * (LIFT_TEXELS * texel));
    vec2 centre = 0.5 * place.xy + 0.5;
    float depth = 0.5 * place.z + 0.5;
    // Widths in map units per unit of map depth.
    float widening = frame.keyDirection.w * view.lightDepth.x / view.lightCentre.w;
    float search = max(widening * 0.5 * depth, 2.0 / frame.shadowSize);
    float blockers = 0.0, blockerDepth = 0.0;
    for (int i = 0; i < BLOCKER_TAPS; ++i) {
        float d = texture(shadowDepth, centre + turn * spiral(i, BLOCKER_TAPS) * search).r;
        float hit = d < depth ? 1.0 : 0.0;
        blockers += hit;
        blockerDepth += hit * d;
    }
    float gap = depth - blockerDepth / max(blockers, 1.0);
    float width = clamp(widening * gap, 1.0 / frame.shadowSize, search);
    float lit = 0.0;
    for (int i = 0; i < SHADOW_TAPS; ++i)
        lit += texture(shadowDepth, centre + turn * spiral(i, SHADOW_TAPS) * width).r < depth ? 0.0 : 1.0;
    bool outside = any(greaterThan(abs(place), vec3(1.0)));
    return outside ? 1.0 : lit / float(SHADOW_TAPS);
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(2 * place, ivec2(frame.width, frame.height) - 1);
    float depth = texelFetch(depthPicture, pixel, 0).r;
    shade = vec4(1.0, 1.0, depth * frame.farDepth, 0.0);
    if (depth >= 1.0) discard;
    vec3 p = viewRay(vec2(pixel) + 0.5) * (depth * frame.farDepth);
    vec3 n = unpackNormal(texelFetch(surfacePicture, pixel, 0).x);
    // Sixteen turns in a 4x4 pattern, which the blur that follows averages.
    int turnIndex = ((place.x & 3) * 4 + (place.y & 3)) * 7 & 15;
    float angle = float(turnIndex) * (6.2831853 / 16.0);
    mat2 turn = mat2(cos(angle), sin(angle), -sin(angle), cos(angle));
    shade.x = ambientReach(pixel, p, n, turn);
    shade.y = dot(n, view.keyInView.xyz) > 0.0 ? keyReach(p, n, turn) : 0.0;
}
