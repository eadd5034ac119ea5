// Data of occlusion.frag for one half-resolution pixel, in one word, so that four come with one gather: view depth in
// the upper 20 bits (a float without its sign and lowest bits), ambient light in 7, key light in 4, and one for things,
// as opposed to ground and sky. It stores what is missing from full light, so that 0 is the open ground.
const float AMBIENT_LEVELS = 127.0;
const float KEY_LEVELS = 15.0;

uint packShade(float depth, float ambient, float key, bool isThing)
{
    return (floatBitsToUint(depth) & 0x7ffff800u) << 1 | uint((1.0 - ambient) * AMBIENT_LEVELS + 0.5) << 5 |
           uint((1.0 - key) * KEY_LEVELS + 0.5) << 1 | uint(isThing);
}

vec4 shadeDepth(uvec4 words)
{
    return uintBitsToFloat(words >> 1 & 0x7ffff800u);
}

vec4 shadeAmbient(uvec4 words)
{
    return 1.0 - vec4(words >> 5 & 127u) / AMBIENT_LEVELS;
}

vec4 shadeKey(uvec4 words)
{
    return 1.0 - vec4(words >> 1 & 15u) / KEY_LEVELS;
}

uvec4 shadeThing(uvec4 words)
{
    return words & 1u;
}
