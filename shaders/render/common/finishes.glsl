// The finishes of surfaces, by what their words have above the colour.
#include "shared/draw_types.h"

uniform samplerBuffer finishes;     // FINISH_TEXELS each

struct Finish {
    float roughness;        // the root of Trowbridge and Reitz's alpha
    float metalness;
    float coat;             // share covered by clear lacquer
    float wrap;             // how far light goes round inside
    float spread;           // diffuse roughness, 0 ... 1 (Oren and Nayar)
    float reflectance;      // of what is no metal, straight on
    uint pattern;           // PATTERN_*
    float patternSize;      // [m]
    float emission;
};

Finish fetchFinish(uint alpha)
{
    int first = int(alpha) * FINISH_TEXELS;
    vec4 a = texelFetch(finishes, first), b = texelFetch(finishes, first + 1);
    return Finish(a.x, a.y, a.z, a.w, b.x, b.y, uint(b.z), b.w, texelFetch(finishes, first + 2).x);
}
