// One thread a mover: how far it would move in the substep if nothing touched it, where the last impulses of its
// contacts bring it from there, and whether its contact candidates are still good. BDF2 (second-order velocities) where
// nothing touched its assembly lately, else symplectic Euler.
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/body/body_load.glsl"
#include "sim/common/contacts/search_margin.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverVelocities;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer moverImpulses;
uniform samplerBuffer searchCentres;
uniform samplerBuffer searchRotations;
uniform usamplerBuffer lastAssemblyState;
BUFFER(vec4, MoverPredictions, moverPredictions);   // field: the centre's move, A
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
#ifdef JOINTED
BUFFER(vec4, BodyLoads, newBodyLoads);
#endif
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(Counters, CountersBlock, counters);

/// First order goes on along the chord of the last turn, which is a turn by less: 1 - phi^2 of it. This much further
/// it goes on by as much: a ball that rolls would else stop.
float chordScale(mat3 chord)
{
    float size = dot(chord[0], chord[0]) + dot(chord[1], chord[1]) + dot(chord[2], chord[2]);   // 4 (1 - cos phi)
    return 1.0 / (1.0 - 0.5 * min(size, LONGEST_CHORD));
}

Field predictedMove(uint m, bool second)
{
    float h = sim.substepTime;
    Field v = fetchField(moverVelocities, m);
    if (!second) {
        bool keepsTurning = false;
#ifdef ROUNDS
        keepsTurning = IS_BODY(m) && fetchRound(m).radius > 0.0;
#endif
#ifdef JOINTED
        keepsTurning = keepsTurning || (IS_BODY(m) && hasJoints(m));
#endif
        if (keepsTurning) v.f *= chordScale(h * v.f);
        return Field(h * (v.t + h * sim.gravity.xyz), h * v.f);
    }
    Field move = fetchField(oldMoverMoves, m), last = fetchField(oldMoverVelocities, m);
    return Field(move.t / 3.0 + h * (8.0 * v.t - 2.0 * last.t + 4.0 * h * sim.gravity.xyz) / 9.0,
                 move.f / 3.0 + h * (8.0 * v.f - 2.0 * last.f) / 9.0);
}

/// How far its farthest particle has come since its candidates were found, at most.
float drift(uint m, SearchCentre found, vec3 centre, vec4 rotation, float radius)
{
    vec4 since = quaternionProduct(rotation, conjugate(texelFetch(searchRotations, int(m))));
    return length(centre - found.position) + 2.0 * length(since.xyz) * radius;
}

void main()
{
    uint m = MOVER_OF_THREAD;
    if (m >= MOVER_END) return;
    MoverInfo mover = fetchMover(m);
    uint now = counters[0].substep;
    uint lastContact = fetchAssembly(lastAssemblyState, mover.assembly).lastContact;
    bool asleep = isAsleep(mover.assembly);
    bool second = sim.secondOrder == 1u && now > 0u && lastContact + 1u != now && !asleep;
    assemblies[mover.assembly].order = second ? 2u : 1u;
    if (isFixed(m)) return;   // its move stays 0, and so do its splits

    vec4 rotation = fetchRotation(m), delta = vec4(0, 0, 0, 1);
    Field move = predictedMove(m, second);
    Field impulse = fetchField(moverImpulses, m);
    vec3 start = fetchCentre(m);
    float scale = contactScale(start);
    impulse = Field(scale * impulse.t, scale * impulse.f);
    float radius = 0.0;
    if (IS_BODY(m)) {
        radius = bodyRadius(m);
        move.f = (matrixFromQuaternion(rotation) + move.f) * fetchMoments(m);
    }
    vec3 shift = move.t + mover.inverseMass * impulse.t;
    bool jointed = false;
#ifdef JOINTED
    jointed = IS_BODY(m) && hasJoints(m);
    if (jointed) {
        // As it moved before, which is how its joints let it move; joint_solve goes on from there.
        Field velocity = fetchField(moverVelocities, m);
        shift = sim.substepTime * velocity.t;
        mat3 turned = matrixFromQuaternion(rotation) + sim.substepTime * velocity.f;
        delta = matchedRotationDelta(turned * fetchMoments(m), rotation, delta);
        RowSum rows = rowSum(m, quaternionProduct(delta, rotation));
        impulse = Field(impulse.t + rows.impulse.t, impulse.f + rows.impulse.f);
        BodyLoad load = loadOf(move, impulse, rows.impulse.f, shift, quaternionProduct(delta, rotation), mover.inverseMass,
                               fetchMoments(m));
        STORE_BODY_LOAD(newBodyLoads, m, load)
    }
#endif
    if (IS_BODY(m) && !jointed) delta = matchedRotationDelta(move.f + impulse.f, rotation, delta);
    STORE_FIELD(moverPredictions, m, move)
    if (asleep) {
        // Contacts and joints take what splits its mass over no impulse for immovable.
        moverMoves[m] = packMove(MoverMove(vec3(0), 0.0));
        moverRotationDeltas[m] = vec4(0, 0, 0, 1);
        return;
    }
    moverMoves[m].xyz = shift;
    moverRotationDeltas[m] = delta;
    vec3 centre = start + shift;
    SearchCentre found = fetchSearchCentre(searchCentres, m);
    if (mover.rankCount > 0u && drift(m, found, centre, quaternionProduct(delta, rotation), radius) > found.margin)
        counters[0].due = 1u;
}
