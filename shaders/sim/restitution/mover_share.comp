// One thread a mover: the share of its collisions' impulses that its energy affords. Their whole gain, s a + s^2 b,
// must not exceed what the substep took from it.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/outside.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer moverSolvedVelocities;
uniform samplerBuffer pairLedgers;
uniform usamplerBuffer pairReferences;
uniform samplerBuffer colliderLedgers;
uniform samplerBuffer moverRestitutionSplits;
BUFFER(vec4, MoverRestitutionShares, moverRestitutionShares);
READ_BUFFER(Counters, CountersBlock, counters);

/// The kinetic energy of a mover [J].
float energyOf(uint m, float mass, Field v)
{
    float energy = 0.5 * mass * dot(v.t, v.t);
    if (!IS_BODY(m)) return energy;
    mat3 moved = v.f * fetchMoments(m);
    for (int column = 0; column < 3; ++column) energy += 0.5 * dot(moved[column], v.f[column]);
    return energy;
}

/// Gains of a mover's contacts, and what it may give back beyond its own loss [J].
vec3 ledgerSum(Mover mover, uint parity)
{
    vec3 sum = vec3(0);
    uvec2 range = listRange(parity, LIST_AS_FIRST, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q) sum += texelFetch(pairLedgers, int(q)).xyz;
    range = listRange(parity, LIST_AS_SECOND, mover.firstRank, mover.rankCount);
    for (uint k = range.x; k < range.y; ++k) {
        uint reference = texelFetch(pairReferences, int(k)).x;
        if (reference != NONE) sum += vec3(1, 1, -1) * texelFetch(pairLedgers, int(reference)).xyz;
    }
    range = listRange(parity, LIST_COLLIDERS, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q) sum += texelFetch(colliderLedgers, int(q)).xyz;
    return sum;
}

/// The largest s of 0 ... 1 for which s gains.x + s^2 gains.y is within a budget.
float affordable(vec2 gains, float budget)
{
    if (gains.x + gains.y <= budget) return 1.0;
    float root = sqrt(gains.x * gains.x + 4.0 * max(gains.y, 0.0) * budget);
    // The larger root, in the form that does not cancel.
    float share = gains.x > 0.0 ? 2.0 * budget / (gains.x + root) : (root - gains.x) / max(2.0 * gains.y, 1e-20);
    return clamp(share, 0.0, 1.0);
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount || !responds(m)) return;
    Mover mover = fetchMover(m);
    moverRestitutionShares[m] = vec4(1);
    if (texelFetch(moverRestitutionSplits, int(m)).x <= 0.0) return;
    if (IS_BODY(m) && hasJoints(m)) return;
    vec3 ledger = ledgerSum(mover, counters[0].listParity);
    float mass = 1.0 / mover.inverseMass;
    Field before = fetchField(oldMoverVelocities, m), solved = fetchField(moverSolvedVelocities, m);
    float budget = energyOf(m, mass, before) - energyOf(m, mass, solved) + ledger.z +
                   mass * dot(outsideAcceleration(m), fetchField(oldMoverMoves, m).t);
    // Scaled by s, the solver's impulses cost s budget + (s - s^2) push.
    vec3 pull = sim.substepTime * outsideAcceleration(m);
    float push = energyOf(m, mass, Field(solved.t - before.t - pull, solved.f - before.f));
    moverRestitutionShares[m] = vec4(affordable(ledger.xy, max(budget, 0.0)),
                                     clamp(1.0 + budget / max(push, 1e-20), 0.0, 1.0), 0, 0);
}
