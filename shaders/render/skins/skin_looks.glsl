// Looks of skins: their materials and pictures.
#include "render/common/surface.glsl"
#include "shared/constants.h"

uniform samplerBuffer skinMaterials;        // alpha cutoff, bits: two-sided, wrap of u and v; its first level, levels
uniform usamplerBuffer skinLevels;          // of each picture, large to small: width, height, first texel
uniform usamplerBuffer skinTexels;          // in the format of unpackAlbedo(), alpha above

struct SkinLooks {
    float alphaCutoff;
    bool twoSided;
    ivec2 wrap;             // TextureWrap
    int firstLevel;
    int levelCount;         // 0: without a picture
};

SkinLooks fetchLooks(int material)
{
    vec4 looks = texelFetch(skinMaterials, material);
    int bits = int(looks.y);
    return SkinLooks(looks.x, (bits & 1) != 0, ivec2(bits >> 1 & 3, bits >> 3), int(looks.z), int(looks.w));
}

// The host's wrapped().
float wrapped(float place, int wrap)
{
    if (wrap == TEXTURE_CLAMP) return clamp(place, 0.0, 1.0);
    if (wrap == TEXTURE_MIRROR) return 1.0 - abs(2.0 * fract(0.5 * place) - 1.0);
    return fract(place);
}

vec4 skinTexel(uvec4 level, ivec2 place, ivec2 wrap)
{
    ivec2 size = ivec2(level.xy);
    ivec2 around = place - size * ivec2(greaterThanEqual(place, size)) + size * ivec2(lessThan(place, ivec2(0)));
    ivec2 held = clamp(place, ivec2(0), size - 1);
    ivec2 inside = ivec2(wrap.x == TEXTURE_REPEAT ? around.x : held.x, wrap.y == TEXTURE_REPEAT ? around.y : held.y);
    uint word = texelFetch(skinTexels, int(level.z) + inside.y * size.x + inside.x).x;
    return vec4(unpackAlbedo(word), float(word >> 24) / 255.0);
}

// The picture, linear, at the level whose texels are about as large as pixels. Derivatives: of uv from pixel to pixel.
vec4 skinPicture(SkinLooks looks, vec2 uv, vec2 uvPerX, vec2 uvPerY)
{
    if (looks.levelCount == 0) return vec4(1.0);
    vec2 size = vec2(texelFetch(skinLevels, looks.firstLevel).xy);
    vec2 acrossX = uvPerX * size, acrossY = uvPerY * size;
    float texels = max(max(dot(acrossX, acrossX), dot(acrossY, acrossY)), 1e-12);
    int wanted = int(floor(0.5 * log2(texels) + 0.5));
    uvec4 level = texelFetch(skinLevels, looks.firstLevel + clamp(wanted, 0, looks.levelCount - 1));
    ivec2 wrap = looks.wrap;
    vec2 place = vec2(wrapped(uv.x, wrap.x), wrapped(uv.y, wrap.y)) * vec2(level.xy) - 0.5;
    ivec2 low = ivec2(floor(place));
    vec2 part = place - floor(place);
    vec4 above = mix(skinTexel(level, low, wrap), skinTexel(level, low + ivec2(1, 0), wrap), part.x);
    vec4 below = mix(skinTexel(level, low + ivec2(0, 1), wrap), skinTexel(level, low + ivec2(1, 1), wrap), part.x);
    return mix(above, below, part.y);
}
