// The parts of a contact's two sides that touch: a particle's ball or its box's face; of a ball or capsule, the surface
// about its centre line. The impulses of balls and capsules act where the surfaces meet, so that angular momentum is
// kept and friction has its true arm. Between other particles they act at the centres: towers of boxes sway otherwise
// (docs/physics.md, friction).
#include "sim/common/contacts/contacts.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/common/contacts/touch.glsl"

/// The point of a mover that a contact is measured from, and how far its surface is from there.
struct Reference {
    vec3 r;          // in the mover's axes [m]
    float radius;    // [m]
    bool round;      // it lies on the centre line of a ball or capsule
};

/// The references of both sides of a pair.
struct References {
    Reference a, b;
};

/// @param excess of both particles' radii. @param difference of the two, from the second to the first [m].
References referencesOf(Pair pair, uvec2 movers, vec2 excess, bool sameAssembly, vec3 difference, vec4 rotationA,
                        vec4 rotationB)
{
    vec3 rA = fetchArm(pair.first).r, rB = fetchArm(pair.second).r;
    References refs = References(Reference(rA, particleRadius(excess.x), false),
                                 Reference(rB, particleRadius(excess.y), false));
    if (sameAssembly) return refs;
    refs.a.round = isRound(pair.first);
    refs.b.round = isRound(pair.second);
    if (!refs.a.round && !refs.b.round) return refs;
    RoundBody a = fetchRound(refs.a.round ? movers.x : 0u), b = fetchRound(refs.b.round ? movers.y : 0u);
    if (refs.a.round) refs.a.radius = a.radius;
    if (refs.b.round) refs.b.radius = b.radius;
    // For two lines: alternately finds each point nearest to the other, starting from the particles.
    for (int k = 0; k < 3; ++k) {
        vec3 atB = rotate(rotationB, refs.b.r - rB) - difference;
        if (refs.a.round) refs.a.r = onLine(a, rA + rotate(conjugate(rotationA), atB));
        vec3 atA = rotate(rotationA, refs.a.r - rA) + difference;
        if (refs.b.round) refs.b.r = onLine(b, rB + rotate(conjugate(rotationB), atA));
    }
    return refs;
}

/// The exit direction of a pair; none for a ball or capsule, whose surface gives the normal.
ExitDirection exitOf(References refs, ExitDirection exit)
{
    if (refs.a.round || refs.b.round) exit.direction = vec3(0);
    return exit;
}

/// From each reference to the point where the two surfaces meet [m].
struct Meeting {
    vec3 fromA, fromB;
};

/// @param difference from the second reference to the first, `separation` and `refs` theirs.
Meeting meetingOf(vec3 difference, Separation separation, References refs)
{
    if (!refs.a.round && !refs.b.round) return Meeting(vec3(0), vec3(0));
    float share = refs.a.radius / (refs.a.radius + refs.b.radius);
    vec3 across = separation.firstTouches >= 0.0 ? separation.normal * dot(separation.normal, difference) : difference;
    vec3 fromA = -share * across - (1.0 - max(separation.firstTouches, 0.0)) * (difference - across);
    return Meeting(fromA, fromA + difference);
}

/// How far a ball's or capsule's contact lies ahead of its middle by rolling friction: where the normal impulse stops
/// the rolling, at most that friction times the radius.
/// @param last how far it lay ahead. @param roll of the centre line since the start of the substep [m].
/// @param impulse the normal one [kg m]. @param inverseMass as the contact's worst [1/kg].
vec3 rollingOffset(float most, vec3 last, vec3 roll, vec3 normal, float impulse, float inverseMass)
{
    if (most <= 0.0 || impulse <= 0.0 || inverseMass <= 0.0) return vec3(0);
    vec3 offset = last + roll / (inverseMass * impulse);
    offset -= normal * dot(normal, offset);
    return offset * min(1.0, most / max(length(offset), 1e-20));
}
