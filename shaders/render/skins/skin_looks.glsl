// How skins look: their materials and pictures.
#include "render/common/surface.glsl"

uniform samplerBuffer skinMaterials;        // alpha cutoff, two-sided, its first level, levels
uniform usamplerBuffer skinLevels;          // of each picture, large to small: width, height, first texel
uniform usamplerBuffer skinTexels;          // as unpackAlbedo() reads them, alpha above

struct SkinLooks {
    float alphaCutoff;
    bool twoSided;
    int firstLevel;
    int levelCount;         // 0: without a picture
};

SkinLooks fetchLooks(int material)
{
    vec4 looks = texelFetch(skinMaterials, material);
    return SkinLooks(looks.x, looks.y != 0.0, int(looks.z), int(looks.w));
}

vec4 skinTexel(uvec4 level, ivec2 place)
{
    ivec2 size = ivec2(level.xy);
    ivec2 inside = place - size * ivec2(greaterThanEqual(place, size)) + size * ivec2(lessThan(place, ivec2(0)));
    uint word = texelFetch(skinTexels, int(level.z) + inside.y * size.x + inside.x).x;
    return vec4(unpackAlbedo(word), float(word >> 24) / 255.0);
}

// The picture, linear, of the level whose texels are about as large as pixels. Derivatives: of uv from pixel to pixel.
vec4 skinPicture(SkinLooks looks, vec2 uv, vec2 uvPerX, vec2 uvPerY)
{
    if (looks.levelCount == 0) return vec4(1.0);
    vec2 size = vec2(texelFetch(skinLevels, looks.firstLevel).xy);
    vec2 acrossX = uvPerX * size, acrossY = uvPerY * size;
    float texels = max(max(dot(acrossX, acrossX), dot(acrossY, acrossY)), 1e-12);
    int wanted = int(floor(0.5 * log2(texels) + 0.5));
    uvec4 level = texelFetch(skinLevels, looks.firstLevel + clamp(wanted, 0, looks.levelCount - 1));
    vec2 place = fract(uv) * vec2(level.xy) - 0.5;
    ivec2 low = ivec2(floor(place));
    vec2 part = place - floor(place);
    vec4 above = mix(skinTexel(level, low), skinTexel(level, low + ivec2(1, 0)), part.x);
    vec4 below = mix(skinTexel(level, low + ivec2(0, 1)), skinTexel(level, low + ivec2(1, 1)), part.x);
    return mix(above, below, part.y);
}
