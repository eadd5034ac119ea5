// One thread a loose particle or a body without joints: its velocity and place at the end of the substep.
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/body/integration.glsl"

layout(local_size_x = GROUP_SIZE) in;

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (!moves(m)) {
        rest(m);
        return;
    }
    Mover mover = fetchMover(m);
    finish(m, mover, motionsOf(m, fetchAssembly(mover.assembly)));
}
