// One thread a slot: the neighbours between which fluids act. Solid particles list fluid ones only.
#include "shared/kernel.glsl"
#include "shared/fluid_grid.glsl"
#include "shared/grid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidSorted;
uniform usamplerBuffer cellStarts;
BUFFER(uvec2, SlotCounts, slotCounts);
BUFFER(uint, SlotNeighbours, slotNeighbours);
BUFFER(Counters, CountersBlock, counters);

uint slotBits(vec4 sorted)
{
    return floatBitsToUint(sorted.w) - 0x01000000u;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= gridMembers()) return;
    vec4 own = texelFetch(fluidSorted, int(k));
    bool ownSolid = (slotBits(own) & 1u) != 0u;
    ivec3 cell = cellOf(own.xyz);
    float reach = step.fluidListReach * step.fluidListReach;
    // Fluid particles act on each other up to the kernel's reach; some come nearer before the step ends.
    float near = 1.1025 * step.fluidReach * step.fluidReach;
    uvec2 counts = uvec2(0);
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = aroundCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint first = texelFetch(cellStarts, int(cells.x)).x; first < end; first += 32u) {
            // Bits first, branch-free; the hits are visited afterwards.
            uint hits = 0u, n = min(end - first, 32u);
            for (uint b = 0u; b < n; ++b) {
                vec3 r = own.xyz - texelFetch(fluidSorted, int(first + b)).xyz;
                hits |= (dot(r, r) < reach ? 1u : 0u) << b;
            }
            while (hits != 0u) {
                vec4 other = texelFetch(fluidSorted, int(first + uint(findLSB(hits))));
                hits &= hits - 1u;
                uint bits = slotBits(other), slot = bits >> 1;
                bool solid = (bits & 1u) != 0u;
                vec3 r = own.xyz - other.xyz;
                if (!solid && !ownSolid && dot(r, r) > near) continue;
                if (slot == k || (solid && ownSolid) || !inAroundRange(cell, range, other.xyz)) continue;
                uint place = solid ? step.fluidSlots - 1u - counts.y : counts.x;
                counts += solid ? uvec2(0, 1) : uvec2(1, 0);
                if (counts.x + counts.y <= step.fluidSlots) slotNeighbours[place * gridParticles() + k] = slot;
            }
        }
    }
    uint total = counts.x + counts.y;
    if (total > step.fluidSlots) {
        atomicOr(counters[0].problems, PROBLEM_FLUID);
        atomicMax(counters[0].wantedNeighbours, total);
    }
    counts.x = min(counts.x, step.fluidSlots);
    slotCounts[k] = uvec2(counts.x, min(counts.y, step.fluidSlots - counts.x));
}
