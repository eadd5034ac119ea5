// Colours as they are, only highlights compressed (Khronos, "PBR Neutral Tone Mapper", 2024).
#include "render/common/tone/srgb_curve.glsl"

const float COMPRESSED_FROM = 0.8 - 0.04;
const float ABOVE = 1.0 - COMPRESSED_FROM;
const float DESATURATION = 0.15;
const float FOOT = 0.08;            // from here on 0.04 is taken away, half of it
const float WHITEST = 0.995;        // of display values that are taken back to light

vec3 displayed(vec3 light)
{
    vec3 color = max(light, 0.0);
    float low = min(color.r, min(color.g, color.b));
    color -= low < FOOT ? low - 6.25 * low * low : 0.5 * FOOT;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < COMPRESSED_FROM) return toSrgb(color);
    float shown = 1.0 - ABOVE * ABOVE / (peak + ABOVE - COMPRESSED_FROM);
    return toSrgb(mix(color * (shown / peak), vec3(shown), 1.0 - 1.0 / (DESATURATION * (peak - shown) + 1.0)));
}

vec3 lightOf(vec3 shown)
{
    vec3 color = fromSrgb(shown);
    float top = max(color.r, max(color.g, color.b)), peak = min(top, WHITEST);
    if (peak >= COMPRESSED_FROM) {
        float before = ABOVE * ABOVE / (1.0 - peak) - ABOVE + COMPRESSED_FROM;
        float white = 1.0 - 1.0 / (DESATURATION * (before - peak) + 1.0);
        color = (color * (peak / top) - white * peak) / (1.0 - white) * (before / peak);
    }
    float low = max(min(color.r, min(color.g, color.b)), 0.0);
    return color + (low < 0.5 * FOOT ? sqrt(low / 6.25) - low : 0.5 * FOOT);
}
