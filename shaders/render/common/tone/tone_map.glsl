// Scene-linear light to display values, by one of several curves, and back.
#include "render/common/tone/srgb_curve.glsl"

#if defined(TONE_NEUTRAL)
#include "render/common/tone/tone_neutral.glsl"
#elif defined(TONE_AGX)
#include "render/common/tone/tone_agx.glsl"
#elif defined(TONE_LINEAR)
vec3 displayed(vec3 light) { return toSrgb(clamp(light, 0.0, 1.0)); }
vec3 lightOf(vec3 shown) { return fromSrgb(shown); }
#else
// Film's curve and the display's gamma in one rational function (J. Hejl and R. Burgess-Dawson, in J. Hable, "Filmic
// Tonemapping Operators", 2010): without powers, which are slow on software drivers.
vec3 displayed(vec3 light)
{
    vec3 x = max(light - 0.004, 0.0);
    return x * (6.2 * x + 0.5) / (x * (6.2 * x + 1.7) + 0.06);
}

// The light that displayed() makes a display value of.
vec3 lightOf(vec3 shown)
{
    vec3 y = min(shown, 0.99), a = 6.2 * (1.0 - y), b = 0.5 - 1.7 * y, c = 0.06 * y;
    return (sqrt(b * b + 4.0 * a * c) - b) / (2.0 * a) + 0.004;
}
#endif

// What passes write of light, and the way back: displayed colours, or light itself where pictures are developed later.
#ifdef LINEAR_LIGHT
vec3 written(vec3 light) { return light; }
vec3 lightIn(vec3 color) { return color; }
vec3 shownOf(vec3 color) { return displayed(color); }
vec3 writtenAs(vec3 shown) { return lightOf(shown); }
#else
vec3 written(vec3 light) { return displayed(light); }
vec3 lightIn(vec3 color) { return lightOf(color); }
vec3 shownOf(vec3 color) { return color; }
vec3 writtenAs(vec3 shown) { return shown; }
#endif

// As the eye sees it, of what is written.
float lightness(vec3 color)
{
    return dot(shownOf(color), vec3(0.299, 0.587, 0.114));
}
