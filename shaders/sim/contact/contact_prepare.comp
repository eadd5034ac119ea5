// One thread a pair of particles: sets its contact's data, and gives it its old impulse. RELEASES: of a world where
// anything may be let go; a body that was starts without old impulses.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "math/spatial.glsl"
#include "sim/common/contacts/contact_point.glsl"
#include "sim/contact/exit_direction.glsl"
#include "sim/contact/old_impulse.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
#ifdef RELEASES
READ_BUFFER(vec4, MoverMoves, moverMoves);   // no texture: sixteen are needed beside it
#endif
uniform samplerBuffer grainFrictions;    // by material
uniform usamplerBuffer pairArrivals;     // by second particle, in the order of arrival, which differs from run to run
BUFFER(uvec4, PairSides, pairSides);
FLOAT_TEXELS(pairArms)
FLOAT_TEXELS(newPairImpulses)
BUFFER(float, PairMeans, pairMeans);
BUFFER(uint, PairReferences, pairReferences);
BUFFER(Counters, CountersBlock, counters);

/// A mass of balls that slide on each other and cannot turn has pi / 2 times their friction (Caquot 1934). Loose
/// particles of one size get less friction, so that their mass has the material's.
#define LOOSE_FRICTION 0.63662

/// Static and kinetic friction of a pair. @param excess of both radii [m].
vec2 pairFriction(Pair pair, uvec2 movers, vec2 excess)
{
    vec2 mean = 0.5 * (fetchMass(pair.first).friction + fetchMass(pair.second).friction);
    if (min(movers.x, movers.y) < sim.bodyCount) return mean;
    if (excess.x == 0.0 || excess.y == 0.0) return LOOSE_FRICTION * mean;
    return 0.5 * (texelFetch(grainFrictions, int(fetchParticle(pair.first).material)).xy +
                  texelFetch(grainFrictions, int(fetchParticle(pair.second).material)).xy);
}

/// The second particle lists its pairs in their order, so that sums over them always have the same order.
void refer(uint parity, uint q, uint secondRank)
{
    uvec2 range = listRange(parity, LIST_AS_SECOND, secondRank, 1u);
    uint index = range.x;
    for (uint k = range.x; k < range.y; ++k) index += texelFetch(pairArrivals, int(k)).x < q ? 1u : 0u;
    if (index < range.y) pairReferences[index] = q;
}

/// The hidden axes of a particle's lattice towards a point at `towards` from it [m]. @param rotation of its body.
/// @param round whether the point is on the centre line of a ball or capsule.
uint hiddenBeside(uint i, vec4 rotation, vec3 towards, bool round)
{
    return hiddenAxes(texelFetch(latticeEnds, int(i)).x, rotate(conjugate(rotation), towards),
                      (round ? ROUND_BESIDE : BESIDE) * sim.diameter);
}

void main()
{
    uint q = gl_GlobalInvocationID.x;
    if (q >= counters[0].pairCount) return;
    uint parity = counters[0].listParity, index = parity * sim.pairCapacity + q;
    Pair pair = fetchPair(pairs, index);
    ParticleRank a = fetchRank(pair.first), b = fetchRank(pair.second);
    Arm armA = fetchArm(pair.first), armB = fetchArm(pair.second);
    vec4 placeA = texelFetch(searchPositions, int(pair.first)), placeB = texelFetch(searchPositions, int(pair.second));
    vec3 difference = placeA.xyz - placeB.xyz;
    vec2 excess = vec2(placeA.w, placeB.w);
    vec4 rotationA = texelFetch(searchRotations, int(a.mover)), rotationB = texelFetch(searchRotations, int(b.mover));
    ContactSides sides;
    sides.movers = uvec2(a.mover, b.mover);
    sides.exit = exitDirection(pair, sides.movers, sim.diameter);
    References refs =
        referencesOf(pair, sides.movers, excess, sides.exit.sameAssembly, difference, rotationA, rotationB);
    float touch = refs.a.radius + refs.b.radius;
    difference += rotate(rotationA, refs.a.r - armA.r) - rotate(rotationB, refs.b.r - armB.r);
    sides.hidden = hiddenBeside(pair.first, rotationA, -difference, refs.b.round) |
                   hiddenBeside(pair.second, rotationB, difference, refs.a.round) << 3;
    Separation separation =
        separationOf(difference, exitOf(refs, sides.exit), rotationA, rotationB, sides.hidden, touch);
    Meeting meeting = meetingOf(difference, separation, refs);
    sides.friction = pairFriction(pair, sides.movers, excess);
    vec3 rA = refs.a.r + rotate(conjugate(rotationA), meeting.fromA);
    vec3 rB = refs.b.r + rotate(conjugate(rotationB), meeting.fromB);
    SideMass massA = sideMass(a.mover, armA, rA, separation.normal);
    SideMass massB = sideMass(b.mover, armB, rB, separation.normal);
    sides.fractions = vec2(massA.fraction, massB.fraction);
    pairSides[q] = packContactSides(sides);
    imageStore(pairArms, int(firstArm(q)), packArm(Arm(rA, massA.worst)));
    imageStore(pairArms, int(secondArm(q)), packArm(Arm(rB, massB.worst)));
    Old old = oldImpulse(parity ^ 1u, pair, a.rank, b.rank);
#ifdef RELEASES
    // Before its release it has pushed something that did not give way.
    if (moverMoves[a.mover].w == JUST_LET_GO || moverMoves[b.mover].w == JUST_LET_GO)
        old = Old(Impulse(vec3(0), 0.0), 0.0);
#endif
    if (separation.distance < touch && old.impulse.normal <= 0.0) old.impulse.normal = ABOUT_TO_ACT;
    imageStore(newPairImpulses, int(index), packImpulse(old.impulse));
    pairMeans[index] = old.mean;
    refer(parity, q, b.rank);
}
