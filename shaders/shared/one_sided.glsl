// One-sided contacts (Macklin et al. 2014, 5.1): a particle of a body knows the way out of it, so that what has come
// into the body leaves it by that way instead of being held by its lattice. Which particle of a pair decides is found
// with the pair; its way stands in the upper bits of the pair's movers, turned as the body was then.
#include "shared/octahedron.glsl"

#define MOVER_MASK 0xffffffu
#define WAY_LEVELS 127.0             // 7 bits an axis: 1 degree
#define WAY_KNOWN 0x80000000u        // with the first mover
#define WAY_DEEP 0x80000000u         // with the second: both particles lie more than a diameter below their surfaces

/// The way out for the first particle of a pair.
struct Way {
    vec3 out;            // unit, or zero for none
    bool deep;
};

/// The bits for both movers.
uvec2 packWay(Way way)
{
    if (way.out == vec3(0)) return uvec2(0);
    uvec2 place = uvec2((0.5 * toSquare(way.out) + 0.5) * WAY_LEVELS + 0.5);
    return place << 24 | uvec2(WAY_KNOWN, way.deep ? WAY_DEEP : 0u);
}

Way unpackWay(uvec2 movers)
{
    vec2 place = vec2(movers >> 24 & 127u) * (2.0 / WAY_LEVELS) - 1.0;
    bool known = (movers.x & WAY_KNOWN) != 0u;
    return Way(known ? fromSquare(place) : vec3(0), (movers.y & WAY_DEEP) != 0u);
}

/// The direction of a contact whose first particle is at `apart` from the second: in the surface layer theirs, mirrored
/// where it points into the body; deep inside the way out itself. w: 1 where it is not simply theirs.
vec4 sidedNormal(vec3 apart, float far, Way way)
{
    float facing = dot(apart, way.out);
    bool deep = way.deep && far < step.diameter;
    vec3 mirrored = (apart - 2.0 * facing * way.out) / max(far, 1e-7);
    return vec4(deep ? way.out : mirrored, deep || facing < 0.0 ? 1.0 : 0.0);
}
