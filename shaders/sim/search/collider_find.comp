// One thread a particle: the static colliders that it may touch.
#include "sim/common/kernel.glsl"
#include "sim/common/colliders.glsl"
#include "sim/common/contact_lists.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;      // w: how far its mover may drift
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer moverColliders;   // bits: those that the mover may touch
BUFFER(uint, ColliderLists, colliderLists);
BUFFER(uint, ListCounts, listCounts);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    vec3 x = texelFetch(searchPositions, int(i)).xyz;
    uvec2 place = texelFetch(particleRanks, int(i)).xy;
    float further = max(texelFetch(searchCentres, int(place.x)).w - sim.drift, 0.0);
    float reach = sim.contactRadius - 0.5 * sim.diameter + further;
    uint near = texelFetch(moverColliders, int(place.x)).x;
    uint count = 0u;
    for (uint block = 0u; near != 0u; block += 32u) {
        for (uint left = near; left != 0u; left &= left - 1u) {
            uint c = block + uint(findLSB(left));
            if (c >= sim.colliderCount || colliderDistance(c, x).w > reach) continue;
            if (count < COLLIDER_SLOTS) colliderLists[count * sim.particleCount + i] = c;
            ++count;
        }
        if (block + 32u >= sim.colliderCount) break;
    }
    if (count > COLLIDER_SLOTS) {
        atomicOr(counters[0].problems, PROBLEM_COLLIDERS);
        atomicMax(counters[0].wantedColliders, count);
    }
    listCounts[listPlace(LIST_COLLIDERS, place.y)] = min(count, COLLIDER_SLOTS);
}
