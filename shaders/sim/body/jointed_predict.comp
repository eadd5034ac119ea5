// One thread a body with joints: how far it would move in the substep if nothing held or touched it. It is put where it
// would be if it went on as before, which is how its joints let it move; joint_solve goes on from there by what is left
// of the prediction and of the last impulses on it.
#define JOINTED
#include "sim/common/kernel.glsl"
#include "sim/body/mover_threads.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/body/body_load.glsl"
#include "sim/body/prediction.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverImpulses;
uniform usamplerBuffer lastAssemblyState;
BUFFER(vec4, MoverPredictions, moverPredictions);   // field: the centre's move, A
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
BUFFER(vec4, BodyLoads, newBodyLoads);
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

    mat3 moments = fetchMoments(m);
    vec4 rotation = fetchRotation(m);
    Field move = predictedMove(m, second, true);
    Field impulse = fetchField(moverImpulses, m);
    float scale = contactScale(fetchCentre(m));
    impulse = Field(scale * impulse.t, scale * impulse.f);
    move.f = (matrixFromQuaternion(rotation) + move.f) * moments;
    Field velocity = fetchField(moverVelocities, m);
    vec3 shift = sim.substepTime * velocity.t;
    mat3 turned = matrixFromQuaternion(rotation) + sim.substepTime * velocity.f;
    vec4 delta = matchedRotationDelta(turned * moments, rotation, vec4(0, 0, 0, 1));
    Field rows = rowSum(m, quaternionProduct(delta, rotation));
    impulse = Field(impulse.t + rows.t, impulse.f + rows.f);
    BodyLoad load = loadOf(move, impulse, rows.f, shift, quaternionProduct(delta, rotation), mover.inverseMass,
                           moments);
    STORE_BODY_LOAD(newBodyLoads, m, load)
    STORE_FIELD(moverPredictions, m, move)
    if (!free) {
        // Contacts and joints take what splits its mass over no impulse for immovable.
        moverMoves[m] = packMove(MoverMove(vec3(0), 0.0));
        moverRotationDeltas[m] = vec4(0, 0, 0, 1);
        return;
    }
    moverMoves[m].xyz = shift;
    moverRotationDeltas[m] = delta;
}
