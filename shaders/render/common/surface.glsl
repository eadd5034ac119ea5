// Output of the geometry passes per pixel for the lighting: a normal and a colour in two words.
#include "math/octahedron.glsl"

// Square roots use the 8 bits a channel where the eye sees steps.
uint packRoots(vec3 roots, float alpha)
{
    return packUnorm4x8(vec4(roots, alpha));
}

vec3 unpackRoots(uint word)
{
    return unpackUnorm4x8(word).rgb;
}

uint packAlbedo(vec3 albedo, float alpha)
{
    return packRoots(sqrt(clamp(albedo, 0.0, 1.0)), alpha);
}

vec3 unpackAlbedo(uint word)
{
    vec3 roots = unpackRoots(word);
    return roots * roots;
}

// The ground's colour words have no alpha.
bool isGround(uvec2 surface)
{
    return surface.y >> 24 == 0u;
}

// The normal may have any length above 0.
uint packNormal(vec3 n)
{
    return packSnorm2x16(toSquare(n));
}

vec3 unpackNormal(uint word)
{
    return fromSquare(unpackSnorm2x16(word));
}
