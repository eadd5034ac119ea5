// The key light that arrives, by the shadow map.
#include "render/common/frame_blocks.glsl"
#include "render/picture/taps.glsl"

uniform sampler2D shadowPicture;

const int BLOCKER_TAPS = 4;
const int SHADOW_TAPS = 6;
// How far a surface is lifted for its shadow test, over the size of a texel, so that it does not shade itself.
const float LIFT_TEXELS = 1.5;

// How much of four texels is lit, weighted by their distances, so that texels do not show (Reeves et al. 1987).
float litShare(vec2 place, float reference)
{
    vec4 lit = vec4(greaterThanEqual(textureGather(shadowPicture, place), vec4(reference)));
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
    // Surfaces beyond the map's depth can be shaded, too, but not by the cleared map.
    float reference = min(depth, 1.0);
    // Widths in map units per unit of map depth.
    float widening = frame.keyDirection.w * view.lightDepth.x / view.lightCentre.w;
    float search = max(widening * 0.5 * depth, 2.0 / frame.shadowSize);
    float blockers = 0.0, blockerDepth = 0.0;
    vec2 direction = pixelDirection(k);
    for (int i = 0; i < BLOCKER_TAPS; ++i) {
        float d = textureLod(shadowPicture, centre + spiral(i, k, BLOCKER_TAPS, direction) * search, 0.0).r;
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
