// One thread a particle: the position for which its contacts are found, and an empty count of the pairs that will refer
// to it. That position lies ahead, where its mover is going, by most of the mover's margin, so that the particle stays
// near it for longer. FROM_POSITIONS: of the paper's solver, its predicted position.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/contact_lists.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/search/sorted_particles.glsl"
#ifdef FROM_POSITIONS
uniform samplerBuffer positions;
uniform samplerBuffer predicted;
#else
uniform samplerBuffer moverReaches;
BUFFER(uint, FastParticles, fastParticles);
BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, SearchCentres, searchCentres);
#endif

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, SearchRotations, searchRotations);
BUFFER(vec4, SearchPositions, searchPositions);
BUFFER(uint, ListCounts, listCounts);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ParticleRank own = fetchRank(i);
    uint mover = own.mover;
    bool isFirst = fetchMover(mover).firstRank == own.rank;
#ifdef FROM_POSITIONS
    searchPositions[i] = texelFetch(positions, int(i)) + texelFetch(predicted, int(i));
    if (isFirst) searchRotations[mover] = fetchRotation(mover);
#else
    MoverPoint point = moverPoint(mover, fetchArm(i).r);
    vec3 move = fetchMove(mover).shift;
    float reach = counters[0].fastCount <= sim.fastLimit ? texelFetch(moverReaches, int(mover)).x : 0.0;
    float margin = sim.drift + reach;
    vec3 ahead = move * min(sim.lookAhead, 0.75 * margin / max(length(move), 1e-20));
    if (margin > sim.drift)
        fastParticles[atomicAdd(counters[0].fastListed, 1u)] = packFastParticle(FastParticle(i, isTold(mover)));
    searchPositions[i] = vec4(point.centre + point.arm + point.move + ahead, 0);
    if (isFirst) {
        searchCentres[mover] = packSearchCentre(SearchCentre(point.centre + move + ahead, margin));
        searchRotations[mover] = quaternionProduct(fetchRotationDelta(mover), fetchRotation(mover));
    }
#endif
    listCounts[listIndex(LIST_AS_SECOND, own.rank)] = 0u;
}
