// A pair of particles of a stack: it acts where their faces meet, so that it keeps angular momentum.
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/touch.glsl"

/// One side: from the centre of its mover to where the pair acts when the substep began, how far both have come since,
/// and from the centre to the particle now [m].
struct Side {
    vec3 arm, shift, move, kept;
};

Side sideAt(uint mover, vec3 arm, vec3 particle)
{
    MoverMove move = fetchMove(mover);
    vec4 delta = fetchRotationDelta(mover);
    return Side(arm, move.shift, movedByTurn(move.shift, delta, arm), movedByTurn(particle, delta, particle));
}

vec3 armNow(Side side)
{
    return side.arm + side.move - side.shift;
}

struct FacePair {
    Side a, b;
    vec3 normal;      // towards the first
    float startGap;   // at the start of the substep [m]
};

/// @param rA, rB places of the particles in their movers' axes [m].
FacePair facePair(Pair pair, ContactSides sides, vec3 rA, vec3 rB)
{
    vec4 rotationA = fetchRotation(sides.movers.x), rotationB = fetchRotation(sides.movers.y);
    vec3 a = rotate(rotationA, rA), b = rotate(rotationB, rB);
    vec3 difference = fetchCentre(sides.movers.x) - fetchCentre(sides.movers.y) + (a - b);
    Separation start = separationOf(difference, sides.exit, rotationA, rotationB, sides.hidden, sim.diameter);
    vec3 across = start.firstTouches >= 0.0 ? start.normal * dot(start.normal, difference) : difference;
    vec3 fromA = -0.5 * across - (1.0 - max(start.firstTouches, 0.0)) * (difference - across);
    float startGap = (start.oneSided && sides.exit.deepInside ? 0.0 : start.distance) - sim.diameter;
    return FacePair(sideAt(sides.movers.x, a + fromA, a), sideAt(sides.movers.y, b + fromA + difference, b),
                    start.normal, startGap);
}
