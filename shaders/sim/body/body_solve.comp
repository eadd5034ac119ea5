// One thread a body without joints: matches it to where impulses bring its particles (eqs. 8-9). An impulse p on a
// particle at r displaces that particle by p / m, which adds p r^T to A and p / M to the centre's move. ROWS: of a
// world where constraints other than joints act on such bodies. AGAIN: after the first iteration, in a world of stacks.
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/contacts/stacks.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer lastMoverRotationDeltas;
uniform samplerBuffer moverPredictions;
uniform samplerBuffer bodyPushes;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (!responds(m)) return;
#ifdef AGAIN
    if (inStack(m)) return;   // stack_solve has moved it
#endif
    Field prediction = fetchField(moverPredictions, m), impulse = fetchField(bodyPushes, m);
    vec4 rotation = fetchRotation(m), delta = texelFetch(lastMoverRotationDeltas, int(m));
#ifdef ROWS
    Field rows = rowSum(m, quaternionProduct(delta, rotation));
    impulse = Field(impulse.t + rows.t, impulse.f + rows.f);
#endif
    moverRotationDeltas[m] = matchedRotationDelta(prediction.f + impulse.f, rotation, delta);
    moverMoves[m].xyz = prediction.t + fetchMover(m).inverseMass * impulse.t;
}
