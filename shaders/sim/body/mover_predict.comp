// One thread a loose particle or a body without joints: how far it would move in the substep if nothing touched it, and
// where the last impulses of its contacts bring it from there.
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/body/prediction.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverImpulses;
uniform usamplerBuffer lastAssemblyState;
BUFFER(vec4, MoverPredictions, moverPredictions);   // field: the centre's move, A
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    if (gl_GlobalInvocationID.x >= THREAD_COUNT) return;
    uint m = moverOfThread(gl_GlobalInvocationID.x);
    bool free = responds(m);
    if (moves(m) && !free) return;   // somebody else says how it moves
    MoverInfo mover = fetchMover(m);
    bool second = isSecondOrder(m, fetchAssembly(lastAssemblyState, mover.assembly).lastContact, counters[0].substep);
    if (free) assemblies[mover.assembly].order = second ? 2u : 1u;

    vec4 rotation = fetchRotation(m), delta = vec4(0, 0, 0, 1);
    bool isRound = false;
#ifdef ROUNDS
    isRound = IS_BODY(m) && fetchRound(m).radius > 0.0;
#endif
    Field move = predictedMove(m, second, isRound);
    Field impulse = fetchField(moverImpulses, m);
    float scale = contactScale(fetchCentre(m));
    impulse = Field(scale * impulse.t, scale * impulse.f);
    if (IS_BODY(m)) {
        move.f = (matrixFromQuaternion(rotation) + move.f) * fetchMoments(m);
        delta = matchedRotationDelta(move.f + impulse.f, rotation, delta);
    }
    STORE_FIELD(moverPredictions, m, move)
    if (!free) {
        // Contacts and joints take what splits its mass over no impulse for immovable.
        moverMoves[m] = packMove(MoverMove(vec3(0), 0.0));
        moverRotationDeltas[m] = vec4(0, 0, 0, 1);
        return;
    }
    moverMoves[m].xyz = move.t + mover.inverseMass * impulse.t;
    moverRotationDeltas[m] = delta;
}
