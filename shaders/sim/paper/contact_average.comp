// One thread a particle: one iteration of count-averaged Jacobi over its contacts (eqs. 3-7; Macklin et al. 2014, 4.2).
// The match of a body averages over all its particles once more, which over-relaxation makes up for, as far as the body
// does not answer by more than is asked. STABILIZE: how far it is to be moved out of the overlaps that it starts in
// (their 4.4).
#include "sim/common/kernel.glsl"
#include "sim/common/assemblies.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/sleep.glsl"
#include "sim/paper/body_acting.glsl"
#include "sim/paper/contact_pushes.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(BodyActingSums, BodyActing, bodyActing);
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(vec4, Moved, moved);              // as predicted, with what contacts ask for [m]; STABILIZE: only that
READ_BUFFER(Counters, CountersBlock, counters);

Side sideOf(uint i)
{
    vec4 move = texelFetch(predicted, int(i));
    return Side(texelFetch(positions, int(i)).xyz, move.xyz, move.w);
}

Push colliderPush(Side own, uvec4 sides)
{
    vec4 surface = colliderDistance(sides.y, own.start + own.move);
    float startGap = colliderDistance(sides.y, own.start).w - 0.5 * sim.diameter;
    Push push = contactPush(surface.xyz, surface.w - 0.5 * sim.diameter, startGap, own.move, unpackHalf2x16(sides.z));
    push.move *= own.inverseMass > 0.0 ? 1.0 : 0.0;
    return push;
}

void add(inout Push sum, Push other)
{
    sum.move += other.move;
    sum.acting += other.acting;
}

/// The sums over the three lists of a particle.
Push allPushes(Side own, uint parity, uint rank)
{
    Push sum = Push(vec3(0), 0.0);
    uint base = parity * sim.pairCapacity;
    uvec2 range = listRange(parity, LIST_AS_FIRST, rank, 1u);
    for (uint q = range.x; q < range.y; ++q)
        add(sum, pairPush(own, sideOf(texelFetch(pairs, int(base + q)).y), true, texelFetch(pairSides, int(q))));
    range = listRange(parity, LIST_AS_SECOND, rank, 1u);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q == NONE) continue;
        add(sum, pairPush(own, sideOf(texelFetch(pairs, int(base + q)).x), false, texelFetch(pairSides, int(q))));
    }
    range = listRange(parity, LIST_COLLIDERS, rank, 1u);
    for (uint q = range.x; q < range.y; ++q) add(sum, colliderPush(own, texelFetch(colliderSides, int(q))));
    return sum;
}

/// How many times as far as its contacts ask a particle of a body is moved, since the match passes on only its share.
/// Counts it among those that are pushed.
float bodyRelaxation(uint i, uint body, Push push)
{
    float fraction = fetchArm(i).worstInverseMass / fetchMass(i).inverseMass;
    if (push.acting > 0.0) atomicAdd(bodyActing[body].now, uint(fraction * FRACTION_PARTS));
    float sum = float(bodyActing[body].last) / FRACTION_PARTS;
    float most = min(1.0 / fraction, MOST_FRACTION_SUM / max(sum, 1e-6));
#ifdef STABILIZE
    return most;
#else
    return min(most, sim.overRelaxation);
#endif
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ParticleInfo info = fetchParticle(i);
    if (isAsleep(info.assembly)) {
        moved[i] = vec4(0);
        return;
    }
    Side own = fetchSide(i);
    Push sum = allPushes(own, counters[0].listParity, fetchRank(i).rank, sim.diameter);
    if (sum.acting > 0.0) assemblies[info.assembly].lastContact = counters[0].substep - 1u;
    float relaxation = info.bodyCount > 0u && own.inverseMass > 0.0 ? bodyRelaxation(i, info.body, sum) : 1.0;
    vec3 push = relaxation / max(sum.acting, 1.0) * sum.move;
#ifdef STABILIZE
    moved[i] = vec4(push, 0);
#else
    moved[i] = vec4(own.move + push, 0);
#endif
}
