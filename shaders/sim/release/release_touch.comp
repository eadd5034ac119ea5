// One thread a release by touch and a body of it: lets go if a particle of the body touches a named one: if they push
// each other, or overlap without either answering.
#include "sim/common/kernel.glsl"
#include "sim/release/release.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/contact_point.glsl"
#include "sim/common/contacts/listed_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer pairImpulses;

/// Whether the surfaces of two particles meet.
bool overlap(Pair pair, uvec2 movers)
{
    vec4 rotationA = fetchRotation(movers.x), rotationB = fetchRotation(movers.y);
    vec3 armA = fetchArm(pair.first).r, armB = fetchArm(pair.second).r;
    vec3 difference = fetchCentre(movers.x) + rotate(rotationA, armA) - fetchCentre(movers.y) -
                      rotate(rotationB, armB);
    References refs = referencesOf(pair, movers, radiusExcess(movers), false, difference, rotationA, rotationB);
    difference += rotate(rotationA, refs.a.r - armA) - rotate(rotationB, refs.b.r - armB);
    return length(difference) < refs.a.radius + refs.b.radius;
}

void main()
{
    uint thread = gl_GlobalInvocationID.x;
    if (thread >= sim.touchWatchCount) return;
    ReleaseWatch watched = fetchReleaseWatch(sim.impulseWatchCount + thread);
    Release release = releases[watched.release];
    Mover body = fetchMover(watched.body);
    uint parity = counters[0].listParity;
    ListedPairs list = pairsOf(body.firstRank, body.rankCount, parity);
    bool touched = false;
    for (uint k = 0u; k < list.count; ++k) {
        ListedPair pair = pairAt(list, k, parity);
        if (pair.index == NONE || pair.other < release.firstParticle || pair.other >= release.particleEnd) continue;
        uint mover = fetchRank(pair.other).mover;
        if (!isAnother(release, mover)) continue;
        touched = touched || fetchImpulse(pairImpulses, pair.index).normal > 0.0 ||
                  overlap(Pair(pair.own, pair.other), uvec2(watched.body, mover));
    }
    if (touched) letGoTouched(release, body.assembly);
}
