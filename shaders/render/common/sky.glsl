// The backdrop: a soft gradient, lighter at the horizon, into which the far ground fades.
#include "render/common/frame_blocks.glsl"

vec3 horizonColor()
{
    return mix(frame.skyColor.rgb, vec3(1.0), 0.45) * 0.95;
}

// `up`: the vertical component of the unit view direction.
vec3 skyRadiance(float up)
{
    float high = max(up, 0.0), low = max(-up, 0.0);
    float rise = high / (high + 0.25);
    vec3 zenith = frame.skyColor.rgb * vec3(0.30, 0.41, 0.60);
    vec3 below = mix(horizonColor(), frame.groundColor.rgb, 0.6 * low / (low + 0.25));
    return up >= 0.0 ? mix(horizonColor(), zenith, rise) : below;
}
