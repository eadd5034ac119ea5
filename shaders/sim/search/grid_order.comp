// One thread a particle: its place in the sorted arrays, cells in order and each cell by particle id, so that
// everything that is later summed over neighbours is summed in one order.
#include "sim/common/kernel.glsl"
#include "sim/common/cell_rank.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;      // w: how far its mover may drift
BUFFER(vec4, SortedPositions, sortedPositions);   // w: bits of the mover's index
BUFFER(uvec4, SortedInfos, sortedInfos);          // particle, assembly, rank, 1 if fast

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uvec2 place = placeInCells(i);
    uvec2 mover = texelFetch(particleRanks, int(i)).xy;
    uvec4 info = uvec4(i, texelFetch(particleInfo, int(i)).z, mover.y,
                       texelFetch(searchCentres, int(mover.x)).w > sim.drift ? 1u : 0u);
    // The index goes through the float's bits, offset away from the denormals that a GPU may flush and below the NaNs.
    vec4 sorted = vec4(texelFetch(searchPositions, int(i)).xyz, uintBitsToFloat(0x01000000u + mover.x));
    sortedPositions[place.x] = sorted;
    sortedInfos[place.x] = info;
    if (place.y == NO_PLACE) return;
    sortedPositions[place.y] = sorted;
    sortedInfos[place.y] = info;
}
