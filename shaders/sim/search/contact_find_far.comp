// One thread a fast particle: the particles that it may touch, all around and further than contact_find looks. Of two
// fast ones the one of lower rank finds the other.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_grid.glsl"
#include "sim/common/grid.glsl"
#include "sim/search/contact_search.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer fastParticles;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer particleInfo;
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;      // w: how far its mover may drift

/// How far a mover drifts beyond the others.
float reachOf(uint particle)
{
    return texelFetch(searchCentres, int(texelFetch(particleRanks, int(particle)).x)).w - sim.drift;
}

bool isContact(uvec4 own, uvec4 other, float far, float reach)
{
    if (other.w != 0u && other.z < own.z) return false;
    float both = reach + (other.w != 0u ? reachOf(other.x) : 0.0);
    if (far >= sim.contactRadius + both) return false;
    return other.y != own.y || mayTouch(own.x, other.x);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= counters[0].fastListed) return;
    uint i = texelFetch(fastParticles, int(k)).x;
    uvec4 own = uvec4(i, texelFetch(particleInfo, int(i)).z, texelFetch(particleRanks, int(i)).y, 1);
    vec3 x = texelFetch(searchPositions, int(i)).xyz;
    float reach = reachOf(i), farthest = sim.contactRadius + reach + sim.farReach;
    ivec3 cell = cellOf(x);
    uint count = 0u;
    for (int range = 0; range < FAR_RANGES; ++range) {
        uvec2 cells = farCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint m = texelFetch(cellStarts, int(cells.x)).x; m < end; ++m) {
            vec3 y = texelFetch(sortedPositions, int(m)).xyz;
            float far = length(x - y);
            if (far >= farthest || !inFarRange(cell, range, y)) continue;
            uvec4 other = texelFetch(sortedInfos, int(m));
            if (isContact(own, other, far, reach)) notePair(own, other, count++);
        }
    }
    noteCount(own, count);
}
