// One thread a mover: for how many steps its assembly has been calm, as far as this mover goes.
#include "sim/common/kernel.glsl"
#include "sim/common/fields.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer moverInfo;
uniform samplerBuffer moverVelocities;
uniform samplerBuffer bodyMoments;       // w of the first of three: radius
BUFFER(uvec2, AssemblyNext, assemblyNext);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    uvec4 info = texelFetch(moverInfo, int(m));
    if (uintBitsToFloat(info.w) == 0.0) return;
    float radius = m < sim.bodyCount ? texelFetch(bodyMoments, int(3u * m)).w : 0.0;
    float speed = fastestOf(fetchField(moverVelocities, m), radius);
    uint calm = texelFetch(assemblyCalm, int(info.z)).x + 1u;
    atomicMin(assemblyNext[info.z].x, speed > sim.sleepSpeed ? 0u : calm);
}
