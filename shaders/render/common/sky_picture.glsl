// A sky that the host has made or read, and what surfaces of a few roughnesses mirror of it. Each map goes once around,
// from the top to the bottom, with a texel of border.
#include "shared/draw_types.h"

uniform sampler2D skyPicture;
uniform sampler2D skyBlurs;         // SKY_BLURS of them, the roughest last

const float SKY_PI = 3.14159265;

// Of a unit direction in view space, 0 to 1 within a map.
vec2 skyPlace(vec3 way)
{
    vec3 world = directionToWorld(way);
    return vec2(fract(atan(-world.x, world.z) / (2.0 * SKY_PI)), acos(clamp(world.y, -1.0, 1.0)) / SKY_PI);
}

vec3 skyAt(vec2 place)
{
    vec2 size = vec2(textureSize(skyPicture, 0));
    return textureLod(skyPicture, (place * (size - 2.0) + 1.0) / size, 0.0).rgb;
}

vec3 skyBlur(vec2 place, int which)
{
    vec2 size = vec2(textureSize(skyBlurs, 0)), map = vec2(size.x, size.y / float(SKY_BLURS));
    vec2 texel = place * (map - 2.0) + 1.0 + vec2(0.0, map.y * float(which));
    return textureLod(skyBlurs, texel / size, 0.0).rgb;
}

vec3 skyTowards(vec3 way)
{
    return skyAt(skyPlace(way));
}

vec3 skyMirrored(vec3 way, float roughness)
{
    vec2 place = skyPlace(way);
    float level = clamp(roughness, 0.0, 1.0) * float(SKY_BLURS);
    int next = min(int(level), SKY_BLURS - 1);
    vec3 sharper = next == 0 ? skyAt(place) : skyBlur(place, next - 1);
    return mix(sharper, skyBlur(place, next), level - float(next));
}

vec3 hazeColor(vec3 ray)
{
    vec3 level = ray - dot(ray, view.upInView.xyz) * view.upInView.xyz;
    return skyTowards(normalize(level + (0.02 * length(level) + 1e-6) * view.upInView.xyz));
}
