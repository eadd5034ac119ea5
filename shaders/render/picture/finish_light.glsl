// How finishes take the light: mirrored by small facets (Trowbridge and Reitz 1975, with the shadowing of Smith, Heitz
// 2014, and the Fresnel term of Schlick 1994), the rest spread (Oren and Nayar 1994, in Fujii's form).
#include "render/common/finishes.glsl"

const float PI = 3.14159265;
const float COAT_ROUGHNESS = 0.1;
const float COAT_REFLECTANCE = 0.04;

struct Facing {
    vec3 normal, toEye;
    float upright;          // cosine between both
};

// Shares of F0 and of 1 that a uniform sky's light comes back with (B. Karis, "Physically Based Shading on Mobile",
// 2014, after D. Lazarov 2013).
vec2 skyShares(float roughness, float upright)
{
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float bend = min(r.x * r.x, exp2(-9.28 * upright)) * r.x + r.y;
    return vec2(-1.04, 1.04) * bend + r.zw;
}

// Of a uniform sky's light, what is mirrored, with what goes between facets more than once (C. Fdez-Aguera, "A
// Multiple-Scattering Microfacet Model for Real-Time Image-based Lighting", 2019).
vec3 mirroredShare(vec3 straight, float roughness, float upright)
{
    vec2 shares = skyShares(roughness, upright);
    vec3 once = straight * shares.x + shares.y, mean = straight + (1.0 - straight) / 21.0;
    float again = 1.0 - shares.x - shares.y;
    return once + again * once * mean / (1.0 - mean * again);
}

vec3 straightReflectance(Finish finish, vec3 albedo)
{
    return mix(vec3(finish.reflectance), albedo, finish.metalness);
}

// D V F, times pi.
vec3 lobe(vec3 straight, float alpha, Facing facing, vec3 way, float lit)
{
    vec3 halfway = normalize(way + facing.toEye);
    float nh = max(dot(facing.normal, halfway), 0.0), a2 = alpha * alpha, flat_ = nh * nh * (a2 - 1.0) + 1.0;
    float v = facing.upright, masking = lit * sqrt(v * v * (1.0 - a2) + a2) + v * sqrt(lit * lit * (1.0 - a2) + a2);
    float rest = 1.0 - max(dot(way, halfway), 0.0), rest2 = rest * rest;
    return (straight + (1.0 - straight) * rest2 * rest2 * rest) * (a2 / (flat_ * flat_) * 0.5 / max(masking, 1e-5));
}

// What comes back of light from one direction, over that of a white matt surface that faces it. @param reach  Share
// that is not in shadow. @param inside  The same of light that goes round. @param width  Tangent of the light's radius.
vec3 directShare(Finish finish, vec3 albedo, Facing facing, vec3 way, float reach, float inside, float width)
{
    float cosine = dot(facing.normal, way), lit = max(cosine, 0.0);
    vec3 straight = straightReflectance(finish, albedo);
    // A light with a size widens the highlight (B. Karis, "Real Shading in Unreal Engine 4", 2013).
    float alpha = clamp(finish.roughness * finish.roughness + 0.5 * width, 0.002, 1.0);
    vec2 shares = skyShares(finish.roughness, facing.upright);
    vec3 mirrored = lobe(straight, alpha, facing, way, lit) * (1.0 + straight * (1.0 / (shares.x + shares.y) - 1.0));
    float along = dot(way, facing.toEye) - lit * facing.upright, even = 1.0 / (1.0 + 0.2877934 * finish.spread);
    float wide = even * (1.0 + finish.spread * along / (along > 0.0 ? max(max(lit, facing.upright), 1e-3) : 1.0));
    float round = max((cosine + finish.wrap) / (1.0 + finish.wrap), 0.0);
    vec3 spread = albedo * (1.0 - finish.metalness) * (1.0 - mirroredShare(straight, finish.roughness, facing.upright));
    // What goes round inside is coloured once more.
    vec3 share = reach * lit * (spread * wide + mirrored) +
                 inside * max(round * round / (1.0 + finish.wrap) - lit * reach, 0.0) * spread * sqrt(albedo);
    vec3 coat = lobe(vec3(COAT_REFLECTANCE), clamp(COAT_ROUGHNESS * COAT_ROUGHNESS + 0.5 * width, 0.002, 1.0), facing,
                     way, lit) * (finish.coat * reach * lit);
    float under = 1.0 - finish.coat * mirroredShare(vec3(COAT_REFLECTANCE), COAT_ROUGHNESS, facing.upright).x;
    return share * under + coat;
}
