// One thread a release by an impulse and a body of it: sums what contacts with others have given to the body in the
// last substeps, as many as a step has, and lets go if that is enough. A blow takes two substeps, which may be in two
// steps. A body that answers to nothing still has the impulses of its contacts, opposite to those on the other side.
// BOUNCES: of a world with restitution, which adds to them.
#include "sim/common/kernel.glsl"
#include "sim/release/release.glsl"
#include "sim/release/release_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer pairImpulses;
uniform samplerBuffer colliderImpulses;
#ifdef BOUNCES
uniform samplerBuffer pairRestitutions;
uniform samplerBuffer colliderRestitutions;
#endif
uniform samplerBuffer lastReleaseImpulses;
BUFFER(vec4, ReleaseImpulses, releaseImpulses);   // one per substep of a step and watch, overwritten in turn [N s]

#ifdef BOUNCES
#define BOUNCE(restitutions, index) fetchImpulse(restitutions, index).normal
#else
#define BOUNCE(restitutions, index) 0.0
#endif

/// A contact's impulse in the substep [N s]: touched bodies move by first order. @param bounce what restitution adds to
/// its normal part, or below 0 [N s].
vec3 impulseOf(Impulse solved, float bounce)
{
    vec3 impulse = solved.whole / sim.substepTime;
    return bounce > 0.0 ? impulse * (1.0 + bounce * sim.substepTime / max(solved.normal, 1e-20)) : impulse;
}

void main()
{
    uint w = gl_GlobalInvocationID.x;
    if (w >= sim.impulseWatchCount) return;
    ReleaseWatch watched = fetchReleaseWatch(w);
    Release release = releases[watched.release];
    Mover body = fetchMover(watched.body);
    uint parity = counters[0].listParity;
    vec3 sum = vec3(0);
    BodyPairs list = pairsOf(body, parity);
    for (uint k = 0u; k < list.count; ++k) {
        BodyPair pair = pairAt(list, k, parity);
        if (pair.index == NONE || !isAnother(release, fetchRank(pair.other).mover)) continue;
        sum += pair.side * impulseOf(fetchImpulse(pairImpulses, pair.index), BOUNCE(pairRestitutions, pair.index));
    }
    uvec2 range = listRange(parity, LIST_COLLIDERS, body.firstRank, body.rankCount);
    for (uint q = range.x; q < range.y; ++q) {
        uint index = parity * sim.colliderPairCapacity + q;
        sum += impulseOf(fetchImpulse(colliderImpulses, index), BOUNCE(colliderRestitutions, index));
    }
    uint first = w * sim.substeps, now = counters[0].substep % sim.substeps;
    releaseImpulses[first + now] = vec4(sum, 0);
    for (uint k = 0u; k < sim.substeps; ++k)
        if (k != now) sum += texelFetch(lastReleaseImpulses, int(first + k)).xyz;
    if (length(sum) >= release.impulse) letGoTouched(release, body.assembly);
}
