// One thread a particle: copies it into the sorted arrays, cells in order and each cell by particle id, so that later
// sums over neighbours always have the same order.
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
BUFFER(uint, SortedParticles, sortedParticles);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uvec2 place = placeInCells(i);
    ParticleRank own = fetchRank(i);
    bool fast = fetchSearchCentre(searchCentres, own.mover).margin > sim.drift;
    uint particle = packSortedParticle(SortedParticle(i, fast)), name = sortedMover(own.mover, isTold(own.mover));
    vec4 position = packSortedPosition(SortedPosition(texelFetch(searchPositions, int(i)).xyz, name));
    bool again;
    do {
        sortedPositions[place.x] = position;
        sortedParticles[place.x] = particle;
        again = place.y != NONE;
        place = uvec2(place.y, NONE);
    } while (again);
}
