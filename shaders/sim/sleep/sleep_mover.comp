// One thread a mover: bounds for how many steps its assembly has been calm, by whether this mover is.
#include "sim/common/kernel.glsl"
#include "sim/common/fields.glsl"
#include "sim/common/bodies.glsl"
#include "sim/common/mover_info.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverVelocities;
BUFFER(Calm, AssemblyNext, assemblyNext);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    if (isFixed(m)) return;
    uint assembly = fetchMover(m).assembly;
    float radius = m < sim.bodyCount ? bodyRadius(m) : 0.0;
    float speed = fastestOf(fetchField(moverVelocities, m), radius);
    uint calm = fetchCalm(assembly).steps + 1u;
    atomicMin(assemblyNext[assembly].steps, speed > sim.sleepSpeed ? 0u : calm);
}
