// The backdrop: a soft gradient, lighter at the horizon, in which the far ground dissolves.
#include "shared/frame_blocks.glsl"

vec3 horizonColor()
{
    return mix(frame.skyColor.rgb, vec3(1.0), 0.45) * 0.95;
}

// `up`: the vertical component of the unit direction looked in.
vec3 skyRadiance(float up)
{
    float rise = 1.0 - exp(-3.2 * max(up, 0.0));
    vec3 zenith = frame.skyColor.rgb * vec3(0.42, 0.52, 0.68);
    vec3 below = mix(horizonColor(), frame.groundColor.rgb, 0.55 * (1.0 - exp(4.0 * min(up, 0.0))));
    return up >= 0.0 ? mix(horizonColor(), zenith, rise) : below;
}
