// One thread a loose particle: sums the impulses on it and moves it by them. Also counts the contacts that will act
// next, over which its mass is split. WARM_START: with the old impulses of new contacts.
#define LOOSE
#ifdef ROPES
#define SKIPS_ROPES
#endif
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/body/contact_response.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverPredictions;
BUFFER(vec4, MoverMoves, moverMoves);

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (!responds(m)) return;
    Mover mover = fetchMover(m);
    ContactResponse contacts = contactResponse(m, mover, 0.0);
    vec3 impulse = contacts.impulse.t + particleSum(mover).t;
    vec3 move = fetchField(moverPredictions, m).t + mover.inverseMass * impulse;
    moverMoves[m] = packMove(MoverMove(move, contacts.splits));
}
