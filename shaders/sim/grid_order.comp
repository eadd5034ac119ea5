// One thread a particle: its place in the sorted arrays, cells in order and each cell by particle id, so that
// everything that is later summed over neighbours is summed in one order.
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer cellCounts;
uniform usamplerBuffer cellMembers;
uniform usamplerBuffer particleCells;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer particlePlaces;   // mover, rank
uniform samplerBuffer foundPositions;
uniform samplerBuffer foundCentres;      // w: how far its mover may drift
BUFFER(vec4, SortedPositions, sortedPositions);   // w: bits of the mover's index
BUFFER(uvec4, SortedInfos, sortedInfos);          // particle, assembly, rank, 1 if fast

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uint cell = texelFetch(particleCells, int(i)).x;
    uint start = texelFetch(cellStarts, int(cell)).x;
    uint count = texelFetch(cellCounts, int(cell)).x;
    uint rank = 0u;
    for (uint k = 0u; k < count; ++k) rank += texelFetch(cellMembers, int(start + k)).x < i ? 1u : 0u;

    uvec2 mover = texelFetch(particlePlaces, int(i)).xy;
    uvec4 info = uvec4(i, texelFetch(particleInfo, int(i)).z, mover.y,
                       texelFetch(foundCentres, int(mover.x)).w > step.drift ? 1u : 0u);
    // The index goes through the float's bits, offset away from the denormals that a GPU may flush and below the NaNs.
    vec4 sorted = vec4(texelFetch(foundPositions, int(i)).xyz, uintBitsToFloat(0x01000000u + mover.x));
    sortedPositions[start + rank] = sorted;
    sortedInfos[start + rank] = info;
    if (cell < WRAPPED_CELLS) {
        uint again = texelFetch(cellStarts, int(step.cellMask + 1u + cell)).x + rank;
        sortedPositions[again] = sorted;
        sortedInfos[again] = info;
    }
}
