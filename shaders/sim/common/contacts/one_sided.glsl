// One-sided contacts (Macklin et al. 2014, 5.1). A particle of a body knows the exit direction, which leads to the
// nearest point of the body's surface. A particle inside the body leaves it in that direction, instead of being held
// between the particles of its lattice. The search settles which particle of a pair decides
// (sim/contact/exit_direction.glsl) and packs the direction, turned as the body was then, into the upper bits of the
// pair's movers.
#include "shared/contact_constants.h"
#include "math/octahedron.glsl"

#define MOVER_MASK 0x7fffffu
#define EXIT_LEVELS 127.0                // 7 bits an axis: 2 degrees at worst
#define EXIT_KNOWN 0x80000000u           // with the first mover
#define EXIT_SAME_ASSEMBLY 0x800000u     // with the first mover
#define EXIT_DEEP_INSIDE 0x80000000u     // with the second mover

/// The direction in which the first particle of a pair leaves the other's body, or minus that of the second one.
struct ExitDirection {
    vec3 direction;      // unit, or zero for none
    bool deepInside;     // both particles lie so far below their surfaces that they would not touch outside
    bool sameAssembly;   // both particles are of one assembly
};

/// The bits to be added to both movers.
uvec2 packExit(ExitDirection exit)
{
    uvec2 bits = uvec2(exit.sameAssembly ? EXIT_SAME_ASSEMBLY : 0u, 0u);
    if (exit.direction == vec3(0)) return bits;
    uvec2 levels = uvec2((0.5 * toSquare(exit.direction) + 0.5) * EXIT_LEVELS + 0.5);
    return bits | levels << 24 | uvec2(EXIT_KNOWN, exit.deepInside ? EXIT_DEEP_INSIDE : 0u);
}

ExitDirection unpackExit(uvec2 movers)
{
    vec2 square = vec2(movers >> 24 & 127u) * (2.0 / EXIT_LEVELS) - 1.0;
    bool known = (movers.x & EXIT_KNOWN) != 0u;
    return ExitDirection(known ? fromSquare(square) : vec3(0), (movers.y & EXIT_DEEP_INSIDE) != 0u,
                         (movers.x & EXIT_SAME_ASSEMBLY) != 0u);
}

struct OneSidedNormal {
    vec3 normal;   // unit, towards the first particle
    bool applies;  // false: the contact's normal is simply the direction between the two particles
};

/// The normal of a contact by the exit direction:
/// - the exit direction itself if both particles are deep inside, or if they are so near to each other that the
///   direction between them says nothing, or the friction of the particles around would hold a sunk particle;
/// - the direction between the two, mirrored, if that points into the body.
/// @param difference from the second particle to the first, `apart` long [m].
/// @param touch the distance at which the two touch [m].
OneSidedNormal oneSidedNormal(vec3 difference, float apart, ExitDirection exit, float touch)
{
    float facing = dot(difference, exit.direction);
    bool deepInside = apart < touch && exit.deepInside;
    bool between = apart < (facing < 0.5 * apart ? SUNK : 0.5) * touch && exit.direction != vec3(0);
    vec3 mirrored = (difference - 2.0 * facing * exit.direction) / max(apart, 1e-7);
    bool exits = deepInside || between;
    return OneSidedNormal(exits ? exit.direction : mirrored, exits || facing < 0.0);
}

/// Direction from the second of two points to the first; up, if they are at most a rounding error apart.
vec3 contactNormal(vec3 difference, float apart)
{
    return apart > 1e-7 ? difference / apart : vec3(0, 1, 0);
}
