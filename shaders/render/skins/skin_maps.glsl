// What pictures say of a skin beside its colour.
#include "render/skins/skin_looks.glsl"

// The normal that a picture has, in axes along u, against v and along `normal`: these come from how place and uv change
// from pixel to pixel (C. Schueler, "Normal Mapping Without Precomputed Tangents", 2006).
vec3 mappedNormal(SkinLooks looks, int material, vec3 normal, vec3 place, vec2 uv)
{
    vec4 map = texelFetch(skinMaterials, SKIN_MATERIAL_TEXELS * material + 1);
    vec2 uvPerX = dFdx(uv), uvPerY = dFdy(uv);
    vec3 perX = dFdx(place), perY = dFdy(place);
    if (map.y == 0.0) return normal;
    vec3 turned = 2.0 * pictureAt(ivec2(map.xy), looks.wrap, uv, uvPerX, uvPerY, false).xyz - 1.0;
    vec3 acrossY = cross(perY, normal), acrossX = cross(normal, perX);
    vec3 alongU = acrossY * uvPerX.x + acrossX * uvPerY.x, alongV = acrossY * uvPerX.y + acrossX * uvPerY.y;
    float size = inversesqrt(max(max(dot(alongU, alongU), dot(alongV, alongV)), 1e-30));
    return normalize(map.z * size * (turned.x * alongU - turned.y * alongV) + max(turned.z, 0.01) * normal);
}

// How much further than the first of ROUGHNESS_STEPS and metals the finish is.
uint mappedFinish(SkinLooks looks, int material, vec2 uv)
{
    vec4 map = texelFetch(skinMaterials, SKIN_MATERIAL_TEXELS * material + 2);
    vec2 found = map.zw * pictureAt(ivec2(map.xy), looks.wrap, uv, dFdx(uv), dFdy(uv), false).yz;
    return 2u * uint(clamp(found.x, 0.0, 1.0) * float(ROUGHNESS_STEPS - 1) + 0.5) + uint(found.y > 0.5);
}
