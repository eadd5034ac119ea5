// One thread a mover: limits its assembly's calm steps, by whether this mover is calm.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverVelocities;
BUFFER(Calm, AssemblyNext, assemblyNext);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    if (!moves(m)) return;
    uint assembly = fetchMover(m).assembly;
    float radius = moverRadius(m);
    float speed = fastestOf(fetchField(moverVelocities, m), radius);
    uint calm = fetchCalm(assembly).steps + 1u;
    atomicMin(assemblyNext[assembly].steps, speed > sim.sleepSpeed ? 0u : calm);
}
