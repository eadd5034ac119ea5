// One thread a body with joints: its velocity, and where it is at the end of the substep.
#define JOINTED
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/body/integration.glsl"

layout(local_size_x = GROUP_SIZE) in;

/// The part of a body's turn that one Newton step of its tree can follow.
float followedPart(mat3 f)
{
    const float MOST_TURN = 0.4;   // in a substep [rad]
    float turn = sim.substepTime * sqrt(0.5 * (dot(f[0], f[0]) + dot(f[1], f[1]) + dot(f[2], f[2])));
    return min(1.0, MOST_TURN / max(turn, 1e-20));
}

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (!moves(m)) {
        rest(m);
        return;
    }
    Mover mover = fetchMover(m);
    Motions motions = motionsOf(m, fetchAssembly(mover.assembly));
    motions.next.f *= followedPart(motions.next.f);
    finish(m, mover, motions);
}
