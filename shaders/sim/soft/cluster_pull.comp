// One thread a particle of a soft body: the impulse that its clusters give it together, implicit in time: one iteration
// (Chebyshev's; each with its own root) of p = h^2 f(x + p / m), with one divisor for the whole body, so that what sums
// to zero stays so. The smoothest strains ask for 1 as the divisor, the steepest for 1 + steepest. FIRST_ITERATION: of a substep,
// from no impulse.
#include "sim/common/kernel.glsl"
#include "sim/common/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer softParticles;    // mover, rank; first entry and count in softLinks
uniform usamplerBuffer softLinks;
uniform samplerBuffer clusterPulls;      // origin, grip; c - origin, steepest; columns of pull + grip F
uniform samplerBuffer moverCentres;
uniform samplerBuffer lastMoverMoves;
uniform samplerBuffer lastParticleImpulses;
uniform samplerBuffer lastSoftImpulses;
uniform usamplerBuffer moverInfo;
layout(location = 0) uniform float root;   // of the iteration, in 0 ... 1
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(vec4, SoftImpulses, softImpulses);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.softCount) return;
    uvec4 own = texelFetch(softParticles, int(i));
    vec3 centre = texelFetch(moverCentres, int(own.x)).xyz;
    vec4 move = texelFetch(lastMoverMoves, int(own.x));
    vec3 wanted = vec3(0);
    float steepest = 0.0;
    for (uint k = own.z; k < own.z + own.w; ++k) {
        LinkValues link = fetchLink(texelFetch(softLinks, int(k)).x);
        int c = int(5u * link.body);
        vec4 origin = texelFetch(clusterPulls, c), offset = texelFetch(clusterPulls, c + 1);
        mat3 pull = mat3(texelFetch(clusterPulls, c + 2).xyz, texelFetch(clusterPulls, c + 3).xyz,
                         texelFetch(clusterPulls, c + 4).xyz);
        vec3 arm = (centre - origin.xyz) + (move.xyz - offset.xyz);
        wanted += link.mass * (pull * link.r - origin.w * arm);
        steepest = offset.w;
    }
    vec3 last = vec3(0);
#ifndef FIRST_ITERATION
    last = texelFetch(lastSoftImpulses, int(i)).xyz;
#endif
    vec3 change = (wanted - last) / max(1.0, root * (1.0 + steepest));
    softImpulses[i] = vec4(last + change, 0);
    particleImpulses[own.y] = texelFetch(lastParticleImpulses, int(own.y)) + vec4(change, 0);
    moverMoves[own.x] = vec4(move.xyz + uintBitsToFloat(texelFetch(moverInfo, int(own.x)).w) * change, move.w);
}
