// A particle's colour word: stored once, or computed from its current speed.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

uniform usamplerBuffer sphereColors;
#ifdef COLOR_BY_SPEED
uniform samplerBuffer velocities;

// Slow to fast: deep blue, teal, green, amber, and near-white heat. Linear RGB.
vec3 speedColor(float share)
{
    const vec3 LIMITS[5] = vec3[5](vec3(0.020, 0.050, 0.230), vec3(0.010, 0.240, 0.360), vec3(0.120, 0.480, 0.160),
                                  vec3(0.900, 0.420, 0.040), vec3(1.000, 0.850, 0.640));
    float place = clamp(share, 0.0, 1.0) * 4.0;
    int below = min(int(place), 3);
    return mix(LIMITS[below], LIMITS[below + 1], place - float(below));
}

uint sphereColor(int particle)
{
    // A stored colour is that of a highlighted joint.
    uint stored = texelFetch(sphereColors, particle).x;
    uint moving = packAlbedo(speedColor(length(texelFetch(velocities, particle).xyz) / frame.speedScale), 1.0);
    return stored != 0u ? stored : moving;
}
#else
uint sphereColor(int particle)
{
    return texelFetch(sphereColors, particle).x;
}
#endif
