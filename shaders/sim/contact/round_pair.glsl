// A pair in an iteration, in a world with balls and capsules: these meet others at their surface, and the impulse acts
// there on both sides, wherever they have turned.
#include "sim/common/contacts/contact_point.glsl"
#include "sim/contact/contact_place.glsl"

/// How far the point where a pair meets lies ahead by rolling friction.
/// @param before where the contact acted, from the first round side's centre line less its offset now. @param roll the
/// centre line's move over the other side.
vec3 aheadOf(ContactSides sides, References refs, vec3 before, vec3 roll, Contact contact, float pressed)
{
    float most = max(refs.a.round ? fetchRound(sides.movers.x).rolling * refs.a.radius : 0.0,
                     refs.b.round ? fetchRound(sides.movers.y).rolling * refs.b.radius : 0.0);
    return rollingOffset(most, before, roll, contact.normal, pressed, contact.worstInverseMass);
}

/// @param armA, armB where the contact acted; where it acts now. @param pressed the last normal impulse [kg m].
Contact pairNow(Pair pair, ContactSides sides, inout Arm armA, inout Arm armB, float pressed)
{
    vec4 rotationA = fetchRotation(sides.movers.x), rotationB = fetchRotation(sides.movers.y);
    vec3 between = fetchCentre(sides.movers.x) - fetchCentre(sides.movers.y);
    vec3 particles = between + (rotate(rotationA, fetchArm(pair.first).r) - rotate(rotationB, fetchArm(pair.second).r));
    vec2 excess = radiusExcess(sides.movers);
    References refs = referencesOf(pair, sides.movers, excess, sides.exit.sameAssembly, particles, rotationA,
                                   rotationB);
    ExitDirection exit = exitOf(refs, sides.exit);
    MoverPoint a = moverPoint(sides.movers.x, refs.a.r), b = moverPoint(sides.movers.y, refs.b.r);
    vec3 startDifference = between + (a.arm - b.arm), difference = startDifference + (a.move - b.move);
    Contact contact;
    contact.touch = refs.a.radius + refs.b.radius;
    Separation start = separationOf(startDifference, exit, rotationA, rotationB, sides.hidden, contact.touch);
    float apart = length(difference);
    start.normal = contact.normal = start.keepsNormal ? start.normal : contactNormal(difference, apart);
    setMasses(contact, sides, armA, armB, vec2(a.splits, b.splits));
    Meeting meeting = meetingOf(difference, start, refs);
    if (refs.a.round || refs.b.round) {
        uint first = sides.movers.x, second = sides.movers.y;
        vec3 before = refs.a.round ? placeOf(first, armA.r) - placeOf(first, refs.a.r) - meeting.fromA
                                   : placeOf(second, armB.r) - placeOf(second, refs.b.r) - meeting.fromB;
        vec3 roll = refs.a.round ? a.move - b.move : b.move - a.move;
        vec3 ahead = aheadOf(sides, refs, before, roll, contact, pressed);
        armA.r = armAt(sides.movers.x, refs.a.r, meeting.fromA + ahead);
        armB.r = armAt(sides.movers.y, refs.b.r, meeting.fromB + ahead);
    }
    vec3 moveA = moverPoint(sides.movers.x, armA.r).move, moveB = moverPoint(sides.movers.y, armB.r).move;
    contact.slide = moveA - moveB;
    // As the body turns, its centre line keeps its distance to the surface, but the point that touches does not.
    vec3 parting = (refs.a.round ? a.move : moveA) - (refs.b.round ? b.move : moveB);
    contact.sameAssembly = sides.exit.sameAssembly;
    setKind(contact, excess);
    contact.leaving = max(dot(a.move, contact.normal), -dot(b.move, contact.normal));
    contact.startGap = (start.oneSided && exit.deepInside ? 0.0 : start.distance) - contact.touch;
    contact.gap = start.keepsNormal ? contact.startGap + dot(parting, start.normal) : apart - contact.touch;
    return contact;
}
