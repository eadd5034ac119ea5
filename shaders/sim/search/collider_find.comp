// One thread a particle: the static colliders that it may touch.
#include "sim/common/kernel.glsl"
#include "sim/common/contacts/colliders.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/contacts/search_margin.glsl"
#include "sim/common/contacts/touch.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "math/quaternion.glsl"
#include "sim/search/candidate_notes.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchPositions;
uniform samplerBuffer searchCentres;
uniform samplerBuffer searchRotations;
uniform usamplerBuffer moverColliders;   // bits: those that the mover may touch

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    vec4 position = texelFetch(searchPositions, int(i));
    vec3 x = position.xyz;
    ParticleRank own = fetchRank(i);
    float reach = colliderReach(position.w) + max(extraMargin(fetchSearchCentre(searchCentres, own.mover)), 0.0);
    uint near = texelFetch(moverColliders, int(own.mover)).x;
    if (isRound(i)) {
        RoundBody body = fetchRound(own.mover);
        vec3 r = fetchArm(i).r;
        x += rotate(texelFetch(searchRotations, int(own.mover)), onLine(body, r) - r);
        reach += body.radius - particleRadius(0.0);
        if ((texelFetch(latticeEnds, int(i)).x & CARRIES_ROUND) == 0u) near = 0u;
    }
    uint count = 0u;
    for (uint block = 0u; near != 0u; block += 32u) {
        for (uint left = near; left != 0u; left &= left - 1u) {
            uint c = block + uint(findLSB(left));
            if (c >= sim.colliderCount || colliderSurface(c, x).distance > reach) continue;
            note(Candidate(i, c, count++, NONE));
        }
        if (block + 32u >= sim.colliderCount) break;
    }
    listCounts[listIndex(LIST_COLLIDERS, own.rank)] = count;
}
