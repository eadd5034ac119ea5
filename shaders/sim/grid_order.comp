// One thread a particle: its place in the sorted arrays, cells in order and each cell by particle id, so that
// everything that is later summed over neighbours is summed in one order.
#include "shared/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer cellCounts;
uniform usamplerBuffer cellMembers;
uniform usamplerBuffer particleCells;
uniform usamplerBuffer particleInfo;
uniform samplerBuffer foundPositions;
BUFFER(vec4, SortedPositions, sortedPositions);   // w: bits of the first body's index
BUFFER(uint, SortedIds, sortedIds);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    uint cell = texelFetch(particleCells, int(i)).x;
    uint start = texelFetch(cellStarts, int(cell)).x;
    uint count = texelFetch(cellCounts, int(cell)).x;
    uint rank = 0u;
    for (uint k = 0u; k < count; ++k) rank += texelFetch(cellMembers, int(start + k)).x < i ? 1u : 0u;

    uint body = texelFetch(particleInfo, int(i)).x;
    // Loose particles are bodies of their own here. The index goes through the float's bits, offset away from the
    // denormals that a GPU may flush and below the NaNs.
    uint tag = body == NO_BODY ? step.bodyCount + i : body;
    vec4 sorted = vec4(texelFetch(foundPositions, int(i)).xyz, uintBitsToFloat(0x01000000u + tag));
    sortedPositions[start + rank] = sorted;
    sortedIds[start + rank] = i;
    if (cell < 2u) {
        uint again = texelFetch(cellStarts, int(step.cellMask + 1u + cell)).x + rank;
        sortedPositions[again] = sorted;
        sortedIds[again] = i;
    }
}
