// One thread a mover: it rests while its assembly sleeps.
#include "sim/common/kernel.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uint, MoverStates, newMoverStates);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount || !mayRest(m)) return;
    newMoverStates[m] = sleeps(fetchCalm(fetchMover(m).assembly)) ? MOVER_ASLEEP : MOVER_DYNAMIC;
}
