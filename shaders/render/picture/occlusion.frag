// Half resolution: how much of the ambient light and of the key light reaches the surface.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/picture/shade.glsl"

layout(binding = DEPTH_UNIT) uniform sampler2D depthPicture;
layout(binding = SURFACE_UNIT) uniform usampler2D surfacePicture;
layout(binding = SHADOW_UNIT) uniform sampler2D shadowDepth;
layout(location = 0) out uint shade;

const int OCCLUSION_TAPS = 5;
const int BLOCKER_TAPS = 4;
const int SHADOW_TAPS = 6;
// A block of 2x2 pixels shares one pattern of four times as many taps; lighting.frag averages such blocks.
const int BLOCK = 4;
const float MAX_OCCLUSION_PIXELS = 110.0;
// Share of a texel that a surface is lifted before it looks for the light, so that it does not shade itself.
const float LIFT_TEXELS = 1.5;
// The golden angle, and four times it, as (cos, sin).
const vec2 GOLDEN = vec2(-0.73736888, 0.67549029);
const vec2 GOLDEN_4 = vec2(-0.98468447, 0.17434580);

vec2 turned(vec2 p, vec2 by)
{
    return vec2(p.x * by.x - p.y * by.y, p.x * by.y + p.y * by.x);
}

// Tap `i` of pixel `k` of its block, of `count`: points of a Vogel spiral, spread evenly over the unit disc.
// `direction` starts at pixelDirection(k) and turns by GOLDEN_4 from tap to tap.
vec2 spiral(int i, int k, int count, vec2 direction)
{
    return sqrt((float(BLOCK * i + k) + 0.5) / float(BLOCK * count)) * direction;
}

vec2 pixelDirection(int k)
{
    vec2 once = (k & 1) != 0 ? GOLDEN : vec2(1.0, 0.0);
    return (k & 2) != 0 ? turned(once, turned(GOLDEN, GOLDEN)) : once;
}

// Ambient obscurance (McGuire et al. 2011, "The Alchemy Screen-Space Ambient Obscurance Algorithm", eq. 10, with the
// falloff of "Scalable Ambient Obscurance", 2012).
float ambientReach(ivec2 pixel, vec3 p, vec3 n, int k)
{
    float radius = frame.occlusionRadius;
    float pixels = min(radius * float(frame.height) / (2.0 * frame.tanHalfFov * -p.z), MAX_OCCLUSION_PIXELS);
    float sum = 0.0;
    vec2 direction = pixelDirection(k);
    for (int i = 0; i < OCCLUSION_TAPS; ++i) {
        vec2 unit = spiral(i, k, OCCLUSION_TAPS, direction);
        direction = turned(direction, GOLDEN_4);
        ivec2 tap = clamp(pixel + ivec2(unit * pixels), ivec2(0),
                          ivec2(frame.width, frame.height) - 1);
        vec3 v = viewRay(vec2(tap) + 0.5) * (texelFetch(depthPicture, tap, 0).r * frame.farDepth) - p;
        float square = dot(v, v);
        float fade = max(1.0 - square / (radius * radius), 0.0);
        sum += fade * fade * max(dot(v, n) - 0.002 * -p.z, 0.0) / (square + 0.01 * radius * radius) * radius;
    }
    return clamp(1.0 - 0.75 * sum / float(OCCLUSION_TAPS), 0.0, 1.0);
}

// How much of four texels is lit, weighted by their distances, so that texels do not show (Reeves et al. 1987).
float litShare(vec2 place, float reference)
{
    vec4 lit = vec4(greaterThanEqual(textureGather(shadowDepth, place), vec4(reference)));
    vec2 between = fract(place * frame.shadowSize - 0.5);
    vec2 columns = mix(lit.wx, lit.zy, between.x);
    return mix(columns.x, columns.y, between.y);
}

// Percentage-closer soft shadows (Fernando 2005).
float keyReach(vec3 p, vec3 n, int k)
{
    float texel = 2.0 * view.lightCentre.w / frame.shadowSize;
    vec3 place = viewToLight(p + n * (LIFT_TEXELS * texel));
    vec2 centre = 0.5 * place.xy + 0.5;
    float depth = 0.5 * place.z + 0.5;
    // What lies behind the map's depth is in its shadows too, but not in that of the cleared map.
    float reference = min(depth, 1.0);
    // Widths in map units per unit of map depth.
    float widening = frame.keyDirection.w * view.lightDepth.x / view.lightCentre.w;
    float search = max(widening * 0.5 * depth, 2.0 / frame.shadowSize);
    float blockers = 0.0, blockerDepth = 0.0;
    vec2 direction = pixelDirection(k);
    for (int i = 0; i < BLOCKER_TAPS; ++i) {
        float d = textureLod(shadowDepth, centre + spiral(i, k, BLOCKER_TAPS, direction) * search, 0.0).r;
        direction = turned(direction, GOLDEN_4);
        float hit = d < reference ? 1.0 : 0.0;
        blockers += hit;
        blockerDepth += hit * d;
    }
    float gap = depth - blockerDepth / max(blockers, 1.0);
    float width = clamp(widening * gap, 1.0 / frame.shadowSize, search);
    float lit = 0.0;
    direction = pixelDirection(k);
    for (int i = 0; i < SHADOW_TAPS; ++i) {
        lit += litShare(centre + spiral(i, k, SHADOW_TAPS, direction) * width, reference);
        direction = turned(direction, GOLDEN_4);
    }
    bool outside = any(greaterThan(abs(place.xy), vec2(1.0)));
    return outside ? 1.0 : lit / float(SHADOW_TAPS);
}

// Whether nothing is near enough to shade a point of the ground. `place`: in the shadow map.
bool isOpen(vec3 place)
{
    float penumbra = frame.keyDirection.w * view.lightDepth.x / view.lightCentre.w * max(place.z + 1.0, 0.0);
    return any(lessThan(place.xy, view.shadedInLight.xy - penumbra)) ||
           any(greaterThan(place.xy, view.shadedInLight.zw + penumbra));
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(2 * place, ivec2(frame.width, frame.height) - 1);
    float depth = texelFetch(depthPicture, pixel, 0).r;
    if (depth >= 1.0) discard;
    vec3 p = viewRay(vec2(pixel) + 0.5) * (depth * frame.farDepth);
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
    if (isGround(surface) && isOpen(viewToLight(p))) discard;
    vec3 n = unpackNormal(surface.x);
    int k = (place.x & 1) + 2 * (place.y & 1);
    float key = dot(n, view.keyInView.xyz) > 0.0 ? keyReach(p, n, k) : 0.0;
    shade = packShade(depth * frame.farDepth, ambientReach(pixel, p, n, k), key, !isGround(surface));
}
