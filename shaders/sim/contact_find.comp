// One thread a particle, in cell order: the particles that it may touch (paper, section 3.1: nearer than 1.2
// diameters), with the impulses of those that it had before. Never particles of a body of its own, nor of its
// assembly where they overlap at rest.
#include "shared/kernel.glsl"
#include "shared/grid.glsl"
#include "shared/old_impulses.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer sortedPositions;
uniform usamplerBuffer sortedIds;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer particleInfo;
uniform samplerBuffer restPositions;
uniform usamplerBuffer particleLinks;    // first entry and count in linksOfParticle
uniform usamplerBuffer linksOfParticle;  // link, its body
BUFFER(uint, Candidates, candidates);
BUFFER(vec4, Impulses, impulses);
BUFFER(uvec2, CandidateCounts, candidateCounts);   // per parity and particle: particles, colliders
BUFFER(Counters, CountersBlock, counters);

bool inSameBody(uint i, uint j)
{
    uvec2 a = texelFetch(particleLinks, int(i)).xy, b = texelFetch(particleLinks, int(j)).xy;
    for (uint k = 0u; k < a.y; ++k)
        for (uint l = 0u; l < b.y; ++l)
            if (texelFetch(linksOfParticle, int(a.x + k)).y == texelFetch(linksOfParticle, int(b.x + l)).y)
                return true;
    return false;
}

bool mayTouch(uint i, uint j, uint assembly)
{
    if (texelFetch(particleInfo, int(j)).z != assembly) return true;
    vec4 a = texelFetch(restPositions, int(i)), b = texelFetch(restPositions, int(j));
    return length(a.xyz - b.xyz) > (0.99 + max(a.w, b.w)) * step.diameter && !inSameBody(i, j);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= step.particleCount) return;
    uint i = texelFetch(sortedIds, int(k)).x;
    uint assembly = texelFetch(particleInfo, int(i)).z;
    vec4 own = texelFetch(sortedPositions, int(k));
    uint ownTag = floatBitsToUint(own.w);
    float reach = step.contactRadius * step.contactRadius;
    ivec3 cell = cellOf(own.xyz);
    uint parity = counters[0].listParity;
    uint oldCount = candidateCounts[(parity ^ 1u) * step.particleCount + i].x;
    uint count = 0u;
    for (int range = 0; range < NEIGHBOUR_RANGES; ++range) {
        uvec2 cells = neighbourCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint first = texelFetch(cellStarts, int(cells.x)).x; first < end; first += 32u) {
            // Bits first, branch-free; the few hits are visited afterwards.
            uint hits = 0u;
            uint n = min(end - first, 32u);
            for (uint b = 0u; b < n; ++b) {
                vec4 other = texelFetch(sortedPositions, int(first + b));
                vec3 r = own.xyz - other.xyz;
                uint hit = dot(r, r) < reach && floatBitsToUint(other.w) != ownTag ? 1u : 0u;
                hits |= hit << b;
            }
            while (hits != 0u) {
                uint b = uint(findLSB(hits));
                hits &= hits - 1u;
                uint j = texelFetch(sortedIds, int(first + b)).x;
                if (!mayTouch(i, j, assembly)) continue;
                if (!inNeighbourRange(cell, range, texelFetch(sortedPositions, int(first + b)).xyz)) continue;
                if (count < step.contactSlots) {
                    uint slot = contactSlot(parity, count, i);
                    candidates[slot] = j;
                    impulses[slot] = oldImpulse(parity ^ 1u, 0u, oldCount, i, j);
                }
                ++count;
            }
        }
    }
    if (count > step.contactSlots) {
        atomicOr(counters[0].problems, PROBLEM_CONTACTS);
        atomicMax(counters[0].wantedContacts, count);
    }
    candidateCounts[parity * step.particleCount + i].x = min(count, step.contactSlots);
}
