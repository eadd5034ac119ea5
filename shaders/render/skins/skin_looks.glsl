// Looks of skins: their materials and pictures.
#include "render/common/surface.glsl"
#include "shared/constants.h"
#include "shared/draw_types.h"

uniform samplerBuffer skinMaterials;        // SKIN_MATERIAL_TEXELS each
uniform usamplerBuffer skinLevels;          // of each picture, large to small: width, height, first texel
uniform usamplerBuffer skinTexels;          // of colours as unpackAlbedo() has them, alpha above; else 8 bits each

struct SkinLooks {
    float alphaCutoff;
    bool twoSided;
    ivec2 wrap;             // TextureWrap
    ivec2 levels;           // of its picture: the first and their number, 0 without one
};

SkinLooks fetchLooks(int material)
{
    vec4 looks = texelFetch(skinMaterials, SKIN_MATERIAL_TEXELS * material);
    int bits = int(looks.y);
    return SkinLooks(looks.x, (bits & 1) != 0, ivec2(bits >> 1 & 3, bits >> 3), ivec2(looks.zw));
}

// The host's wrapped().
float wrapped(float place, int wrap)
{
    if (wrap == TEXTURE_CLAMP) return clamp(place, 0.0, 1.0);
    if (wrap == TEXTURE_MIRROR) return 1.0 - abs(2.0 * fract(0.5 * place) - 1.0);
    return fract(place);
}

vec4 skinTexel(uvec4 level, ivec2 place, ivec2 wrap, bool isColor)
{
    ivec2 size = ivec2(level.xy);
    ivec2 around = place - size * ivec2(greaterThanEqual(place, size)) + size * ivec2(lessThan(place, ivec2(0)));
    ivec2 held = clamp(place, ivec2(0), size - 1);
    ivec2 inside = ivec2(wrap.x == TEXTURE_REPEAT ? around.x : held.x, wrap.y == TEXTURE_REPEAT ? around.y : held.y);
    uint word = texelFetch(skinTexels, int(level.z) + inside.y * size.x + inside.x).x;
    return isColor ? vec4(unpackAlbedo(word), float(word >> 24) / 255.0) : unpackUnorm4x8(word);
}

// A picture, linear, at the level whose texels are about as large as pixels. Derivatives: of uv from pixel to pixel.
vec4 pictureAt(ivec2 levels, ivec2 wrap, vec2 uv, vec2 uvPerX, vec2 uvPerY, bool isColor)
{
    if (levels.y == 0) return vec4(1.0);
    vec2 size = vec2(texelFetch(skinLevels, levels.x).xy);
    vec2 acrossX = uvPerX * size, acrossY = uvPerY * size;
    float texels = max(max(dot(acrossX, acrossX), dot(acrossY, acrossY)), 1e-12);
    int wanted = int(floor(0.5 * log2(texels) + 0.5));
    uvec4 level = texelFetch(skinLevels, levels.x + clamp(wanted, 0, levels.y - 1));
    vec2 place = vec2(wrapped(uv.x, wrap.x), wrapped(uv.y, wrap.y)) * vec2(level.xy) - 0.5;
    ivec2 low = ivec2(floor(place));
    vec2 part = place - floor(place);
    vec4 above = mix(skinTexel(level, low, wrap, isColor), skinTexel(level, low + ivec2(1, 0), wrap, isColor), part.x);
    vec4 below = mix(skinTexel(level, low + ivec2(0, 1), wrap, isColor),
                     skinTexel(level, low + ivec2(1, 1), wrap, isColor), part.x);
    return mix(above, below, part.y);
}

vec4 skinPicture(SkinLooks looks, vec2 uv, vec2 uvPerX, vec2 uvPerY)
{
    return pictureAt(looks.levels, looks.wrap, uv, uvPerX, uvPerY, true);
}
