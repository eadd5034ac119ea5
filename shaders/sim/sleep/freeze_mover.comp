// One thread a mover: whether its farthest particle has left the place from which its assembly counts its calm steps
// (paper, section 3.1: freezing). An assembly that has counts anew from where it is.
#include "sim/common/kernel.glsl"
#include "math/quaternion.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer moverInfo;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
uniform samplerBuffer bodyMoments;       // w of the first of three: radius
uniform samplerBuffer positions;
uniform usamplerBuffer rankedParticles;
BUFFER(vec4, CalmCentres, calmCentres);
BUFFER(vec4, CalmRotations, calmRotations);
BUFFER(uvec2, AssemblyNext, assemblyNext);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    uvec4 info = texelFetch(moverInfo, int(m));
    if (uintBitsToFloat(info.w) == 0.0) return;
    bool body = m < sim.bodyCount;
    vec3 centre = body ? texelFetch(moverCentres, int(m)).xyz
                       : texelFetch(positions, int(texelFetch(rankedParticles, int(info.x)).x)).xyz;
    vec4 rotation = texelFetch(moverRotations, int(m));
    if (texelFetch(assemblyCalm, int(info.z)).x == 0u) {
        calmCentres[m] = vec4(centre, 0);
        calmRotations[m] = rotation;
        return;
    }
    vec4 turn = quaternionProduct(rotation, conjugate(calmRotations[m]));
    float radius = body ? texelFetch(bodyMoments, int(3u * m)).w : 0.0;
    float come = length(centre - calmCentres[m].xyz) + 2.0 * length(turn.xyz) * radius;
    if (come > sim.freeze) assemblyNext[info.z].x = 0u;
}
