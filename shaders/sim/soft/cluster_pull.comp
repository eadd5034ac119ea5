// One thread a particle of a soft body: the sum of its clusters' impulses, implicit in time: one of Chebyshev's
// iterations of p = h^2 f(x + p / m). The whole body has the same factors, so that sums of zero stay zero.
// FIRST_ITERATION: of a substep, starts from no impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/soft/clusters.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer softParticles;
uniform usamplerBuffer softLinks;
uniform samplerBuffer lastMoverMoves;
uniform samplerBuffer lastParticleImpulses;
uniform samplerBuffer lastSoftImpulses;
layout(location = 0) uniform uvec2 range;   // of particles: first, end
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(vec4, SoftImpulses, softImpulses);

/// What never changes about a particle of a soft body.
struct SoftParticle {
    uint mover, rank;
    uint firstLink, linkCount;   // in softLinks
};

SoftParticle fetchSoftParticle(uint i)
{
    uvec4 t = texelFetch(softParticles, int(i));
    return SoftParticle(t.x, t.y, t.z, t.w);
}

void main()
{
    uint i = range.x + gl_GlobalInvocationID.x;
    if (i >= range.y) return;
    SoftParticle own = fetchSoftParticle(i);
    if (own.linkCount == 0u) return;
    vec2 factors = fetchChebyshevFactors(fetchLink(texelFetch(softLinks, int(own.firstLink)).x).body);
    if (factors == NO_CHANGE) return;
    vec3 centre = fetchCentre(own.mover), wanted = vec3(0);
    MoverMove moved = unpackMove(texelFetch(lastMoverMoves, int(own.mover)));
    for (uint k = own.firstLink; k < own.firstLink + own.linkCount; ++k) {
        LinkValues link = fetchLink(texelFetch(softLinks, int(k)).x);
        ClusterPull cluster = fetchClusterPull(link.body);
        vec3 arm = (centre - cluster.origin) + (moved.shift - cluster.centre);
        wanted += link.mass * (cluster.pull * link.r - cluster.grip * arm);
    }
    vec3 last = vec3(0), lastChange = vec3(0);
#ifndef FIRST_ITERATION
    last = texelFetch(lastSoftImpulses, int(2u * i)).xyz;
    lastChange = texelFetch(lastSoftImpulses, int(2u * i + 1u)).xyz;
#endif
    vec3 change = factors.x * (wanted - last) + factors.y * lastChange;
    softImpulses[2u * i] = vec4(last + change, 0);
    softImpulses[2u * i + 1u] = vec4(change, 0);
    particleImpulses[own.rank] = texelFetch(lastParticleImpulses, int(own.rank)) + vec4(change, 0);
    if (!responds(own.mover)) return;   // its clusters pull on the body that holds it
    moved.shift += fetchMover(own.mover).inverseMass * change;
    moverMoves[own.mover] = packMove(moved);
}
