// One thread a particle: the static colliders that it may touch, with the impulses of those that it had before.
#include "shared/kernel.glsl"
#include "shared/colliders.glsl"
#include "shared/old_impulses.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer foundPositions;
BUFFER(uint, Candidates, candidates);
BUFFER(vec4, Impulses, impulses);
BUFFER(uvec2, CandidateCounts, candidateCounts);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount) return;
    vec3 x = texelFetch(foundPositions, int(i)).xyz;
    uint parity = counters[0].listParity;
    float reach = step.contactRadius - 0.5 * step.diameter;
    uint oldCount = candidateCounts[(parity ^ 1u) * step.particleCount + i].y;
    uint count = 0u;
    for (uint c = 0u; c < step.colliderCount; ++c) {
        if (colliderDistance(c, x).w > reach) continue;
        if (count < COLLIDER_SLOTS) {
            uint slot = colliderSlot(parity, count, i);
            candidates[slot] = c;
            impulses[slot] = oldImpulse(parity ^ 1u, step.contactSlots, oldCount, i, c);
        }
        ++count;
    }
    if (count > COLLIDER_SLOTS) {
        atomicOr(counters[0].problems, PROBLEM_COLLIDERS);
        atomicMax(counters[0].wantedColliders, count);
    }
    candidateCounts[parity * step.particleCount + i].y = min(count, COLLIDER_SLOTS);
}
