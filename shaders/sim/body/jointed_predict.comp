// One thread a body with joints: how far it would move in the substep if nothing held or touched it. It is put where it
// would be if it continued as before, which its joints allow; from there joint_solve applies what is left of the
// prediction and of the last impulses on it.
#define JOINTED
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/body/body_load.glsl"
#include "sim/body/prediction.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, BodyLoads, newBodyLoads);

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    if (moves(m) && !responds(m)) return;   // its clip moves it
    Mover mover = fetchMover(m);
    bool second = beginOrder(m, mover.assembly);

    mat3 moments = fetchMoments(m);
    vec4 rotation = fetchRotation(m);
    Field move = predictedMove(m, second, true);
    Field impulse = lastContactImpulse(m);
    move.f = move.f * moments;
    Field velocity = fetchField(moverVelocities, m);
    vec3 shift = sim.substepTime * velocity.t;
    mat3 turned = matrixFromQuaternion(rotation) + sim.substepTime * velocity.f;
    vec4 delta = matchedRotationDelta(turned * moments, rotation, vec4(0, 0, 0, 1));
    Field rows = rowSum(m, quaternionProduct(delta, rotation));
    impulse = Field(impulse.t + rows.t, impulse.f + rows.f);
    BodyLoad load = loadOf(move, impulse, rows.f, shift, rotation, delta, mover.inverseMass, moments);
    STORE_BODY_LOAD(newBodyLoads, m, load)
    STORE_FIELD(moverPredictions, m, move)
    storeStart(m, shift, delta);
}
