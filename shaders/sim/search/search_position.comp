// One thread a particle: the position for which its contacts are found (search_centre), with the excess of its radius
// (sim/common/contacts/touch.glsl), and a zero count of the pairs that will refer to it. FROM_POSITIONS: of the paper's
// solver, its predicted position.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/contact_lists.glsl"
#include "sim/common/particles.glsl"
#ifdef FROM_POSITIONS
uniform samplerBuffer positions;
uniform samplerBuffer predicted;
#else
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/search/sorted_particles.glsl"
uniform samplerBuffer searchCentres;
uniform samplerBuffer searchRotations;
BUFFER(uint, FastParticles, fastParticles);
BUFFER(Counters, CountersBlock, counters);
#endif

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, SearchPositions, searchPositions);
BUFFER(uint, ListCounts, listCounts);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ParticleRank own = fetchRank(i);
#ifdef FROM_POSITIONS
    searchPositions[i] = vec4(texelFetch(positions, int(i)).xyz + texelFetch(predicted, int(i)).xyz, 0);
#else
    SearchCentre centre = fetchSearchCentre(searchCentres, own.mover);
    if (centre.margin > sim.drift)
        fastParticles[atomicAdd(counters[0].fastListed, 1u)] = packFastParticle(FastParticle(i, isTold(own.mover)));
    vec4 rotation = texelFetch(searchRotations, int(own.mover));
    searchPositions[i] = vec4(centre.position + rotate(rotation, fetchArm(i).r), radiusExcess(own.mover));
#endif
    listCounts[listIndex(LIST_AS_SECOND, own.rank)] = 0u;
}
