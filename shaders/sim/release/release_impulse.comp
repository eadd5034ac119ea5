// One thread a release by an impulse and a body of it: sums what contacts with others have given to the body in the
// last substeps, as many as a step has, and lets go if that is enough. A blow takes two substeps, which may be in two
// steps. A body that answers to nothing still has the impulses of its contacts, opposite to those on the other side.
// BOUNCES: of a world with restitution, which adds to them.
#include "sim/common/kernel.glsl"
#include "sim/release/release.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/given_impulses.glsl"
#include "sim/common/contacts/listed_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer lastReleaseImpulses;
BUFFER(vec4, ReleaseImpulses, releaseImpulses);   // one per substep of a step and watch, overwritten in turn [N s]

void main()
{
    uint w = gl_GlobalInvocationID.x;
    if (w >= sim.impulseWatchCount) return;
    ReleaseWatch watched = fetchReleaseWatch(w);
    Release release = releases[watched.release];
    Mover body = fetchMover(watched.body);
    uint parity = counters[0].listParity;
    vec3 sum = vec3(0);
    ListedPairs list = pairsOf(body.firstRank, body.rankCount, parity);
    for (uint k = 0u; k < list.count; ++k) {
        ListedPair pair = pairAt(list, k, parity);
        if (pair.index == NONE || !isAnother(release, fetchRank(pair.other).mover)) continue;
        sum += pair.side * pairGave(pair.index);
    }
    uvec2 range = listRange(parity, LIST_COLLIDERS, body.firstRank, body.rankCount);
    for (uint q = range.x; q < range.y; ++q) sum += colliderGave(parity * sim.colliderPairCapacity + q);
    uint first = w * sim.substeps, now = counters[0].substep % sim.substeps;
    releaseImpulses[first + now] = vec4(sum, 0);
    for (uint k = 0u; k < sim.substeps; ++k)
        if (k != now) sum += texelFetch(lastReleaseImpulses, int(first + k)).xyz;
    if (length(sum) >= release.impulse) letGoTouched(release, body.assembly);
}
