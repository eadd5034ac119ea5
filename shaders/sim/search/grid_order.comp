// One thread a particle: copies it into the sorted arrays, cells in order and each cell by particle id, so that
// everything that is later summed over neighbours is summed in one order.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/cell_rank.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/search/sorted_particles.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;
BUFFER(vec4, SortedPositions, sortedPositions);
BUFFER(uvec4, SortedInfos, sortedInfos);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uvec2 place = placeInCells(i);
    ParticleRank own = fetchRank(i);
    bool fast = fetchSearchCentre(searchCentres, own.mover).margin > sim.drift;
    uvec4 info = packSortedInfo(SortedInfo(i, fetchParticle(i).assembly, own.rank, fast));
    uint name = sortedMover(own.mover, isTold(own.mover));
    vec4 sorted = packSortedPosition(SortedPosition(texelFetch(searchPositions, int(i)).xyz, name));
    sortedPositions[place.x] = sorted;
    sortedInfos[place.x] = info;
    if (place.y == NONE) return;
    sortedPositions[place.y] = sorted;
    sortedInfos[place.y] = info;
}
