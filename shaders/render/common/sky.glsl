// The backdrop: a soft gradient, lighter at the horizon, into which the far ground fades; or a picture of a sky.
#include "render/common/frame_blocks.glsl"

#ifdef SKY_PICTURE
#include "render/common/sky_picture.glsl"
#else
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

// Of a unit direction in view space.
vec3 skyTowards(vec3 way)
{
    return skyRadiance(dot(way, view.upInView.xyz));
}

// What a surface of a roughness mirrors of it: below the horizon the ground, which comes up to it.
vec3 skyMirrored(vec3 way, float roughness)
{
    float up = dot(way, view.upInView.xyz), low = max(-up, 0.0);
    vec3 all = mix(frame.groundColor.rgb, frame.skyColor.rgb, 0.5 + 0.5 * up);
    vec3 sharp = mix(skyRadiance(max(up, 0.0)), frame.groundColor.rgb, low / (low + 0.04));
    return mix(sharp, all, roughness * roughness * (3.0 - 2.0 * roughness));
}

// What far ground fades into. `ray`: in view space, of any length.
vec3 hazeColor(vec3 ray)
{
    return horizonColor();
}
#endif
