// One-sided contacts (Macklin et al. 2014, 5.1): a particle of a body knows the way out of it, so that what has come
// into the body leaves it by that way instead of being held by its lattice. Which particle of a pair decides is found
// with the pair; its way stands in the upper bits of the pair's movers, turned as the body was then.
#include "math/octahedron.glsl"

#define MOVER_MASK 0x7fffffu
#define WAY_LEVELS 127.0             // 7 bits an axis: 2 degrees at worst
#define WAY_KNOWN 0x80000000u        // with the first mover
#define WAY_KIN 0x800000u           // with the first: both sides are of one assembly
#define WAY_DEEP 0x80000000u         // with the second: both particles lie more than a diameter below their surfaces

/// The way out for the first particle of a pair.
struct Way {
    vec3 away;           // unit, or zero for none
    bool deep;
    bool kin;            // both sides are of one assembly
};

/// The bits for both movers.
uvec2 packWay(Way way)
{
    uvec2 kin = uvec2(way.kin ? WAY_KIN : 0u, 0u);
    if (way.away == vec3(0)) return kin;
    uvec2 place = uvec2((0.5 * toSquare(way.away) + 0.5) * WAY_LEVELS + 0.5);
    return kin | place << 24 | uvec2(WAY_KNOWN, way.deep ? WAY_DEEP : 0u);
}

Way unpackWay(uvec2 movers)
{
    vec2 place = vec2(movers >> 24 & 127u) * (2.0 / WAY_LEVELS) - 1.0;
    bool known = (movers.x & WAY_KNOWN) != 0u;
    return Way(known ? fromSquare(place) : vec3(0), (movers.y & WAY_DEEP) != 0u, (movers.x & WAY_KIN) != 0u);
}

/// The direction of a contact whose first particle is at `apart` from the second: theirs, or mirrored where that points
/// into the body, or the way out itself where the particle is deep in the body, has sunk between particles of its
/// surface, whose friction would hold it there, or is so near to one that their direction says nothing. w: 1 where it is
/// not simply theirs.
vec4 sidedNormal(vec3 apart, float far, Way way)
{
    float facing = dot(apart, way.away);
    bool deep = far < sim.diameter && way.deep;
    bool between = far < (facing < 0.5 * far ? SUNK : 0.5) * sim.diameter && way.away != vec3(0);
    vec3 mirrored = (apart - 2.0 * facing * way.away) / max(far, 1e-7);
    return vec4(deep || between ? way.away : mirrored, deep || between || facing < 0.0 ? 1.0 : 0.0);
}
