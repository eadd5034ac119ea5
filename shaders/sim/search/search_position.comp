// One thread a particle: the place for which its contacts are found, and an empty count of the pairs that will refer to
// it. The place lies on its predicted way, ahead of it by most of its margin, so that it stays near that place for
// longer.
#include "sim/common/kernel.glsl"
#include "sim/common/contact_lists.glsl"
#ifdef FROM_POSITIONS
uniform samplerBuffer positions;
uniform samplerBuffer predicted;
uniform samplerBuffer moverRotations;
#else
#include "sim/common/movers.glsl"
uniform samplerBuffer restOffsets;
uniform samplerBuffer moverReaches;
BUFFER(uint, FastParticles, fastParticles);
BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, SearchCentres, searchCentres);
#endif

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer moverInfo;
BUFFER(vec4, SearchRotations, searchRotations);
BUFFER(vec4, SearchPositions, searchPositions);
BUFFER(uint, ListCounts, listCounts);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uvec2 place = texelFetch(particleRanks, int(i)).xy;
    uint mover = place.x;
    bool isFirst = texelFetch(moverInfo, int(mover)).x == place.y;
#ifdef FROM_POSITIONS
    searchPositions[i] = texelFetch(positions, int(i)) + texelFetch(predicted, int(i));
    if (isFirst) searchRotations[mover] = texelFetch(moverRotations, int(mover));
#else
    MoverPoint point = moverPoint(mover, texelFetch(restOffsets, int(i)).xyz);
    vec3 move = texelFetch(moverMoves, int(mover)).xyz;
    float reach = counters[0].fastCount <= sim.fastLimit ? texelFetch(moverReaches, int(mover)).x : 0.0;
    float drift = sim.drift + reach;
    vec3 ahead = move * min(sim.lookAhead, 0.75 * drift / max(length(move), 1e-20));
    if (drift > sim.drift) fastParticles[atomicAdd(counters[0].fastListed, 1u)] = i;
    searchPositions[i] = vec4(point.centre + point.arm + point.move + ahead, 0);
    if (isFirst) {
        searchCentres[mover] = vec4(point.centre + move + ahead, drift);
        searchRotations[mover] = quaternionProduct(texelFetch(moverRotationDeltas, int(mover)),
                                                  texelFetch(moverRotations, int(mover)));
    }
#endif
    listCounts[listPlace(LIST_AS_SECOND, place.y)] = 0u;
}
