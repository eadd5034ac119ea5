// One thread a loose particle or a body without joints: how far it would move in the substep if nothing touched it, and
// where the last impulses of its contacts bring it from there.
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/body/prediction.glsl"

layout(local_size_x = GROUP_SIZE) in;

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (moves(m) && !responds(m)) return;   // its clip moves it
    Mover mover = fetchMover(m);
    bool second = beginOrder(m, mover.assembly);

    vec4 rotation = fetchRotation(m), delta = vec4(0, 0, 0, 1);
    bool isRound = false;
#ifdef ROUNDS
    isRound = IS_BODY(m) && fetchRound(m).radius > 0.0;
#endif
    Field move = predictedMove(m, second, isRound);
    Field impulse = lastContactImpulse(m);
    if (IS_BODY(m)) {
        move.f = (matrixFromQuaternion(rotation) + move.f) * fetchMoments(m);
        delta = matchedRotationDelta(move.f + impulse.f, rotation, delta);
    }
    STORE_FIELD(moverPredictions, m, move)
    storeStart(m, move.t + mover.inverseMass * impulse.t, delta);
}
