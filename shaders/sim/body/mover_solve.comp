// One thread a mover: sums the impulses on it, and matches it to where they bring its particles (eqs. 8-9). An impulse
// p on a particle at r displaces that particle by p / m, which adds p r^T to A and p / M to the centre's move. Also
// counts the contacts that will act next, over which its mass is split (Tonge et al. 2012, mass splitting). WARM_START:
// after the contacts were found anew, with their old impulses alone, as mover_predict does.
#include "sim/common/kernel.glsl"
#include "sim/rotation/rotation_delta.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/body_rows.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/contacts/impulse_sums.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/body/body_load.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer lastMoverRotationDeltas;
uniform samplerBuffer moverPredictions;
uniform samplerBuffer lastMoverImpulses;
uniform samplerBuffer lastMoverChanges;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
BUFFER(vec4, MoverImpulses, moverImpulses);   // field: the sums of contacts
BUFFER(vec4, MoverChanges, moverChanges);     // field: how they changed last; with the relaxation
#ifdef JOINTED
BUFFER(vec4, BodyLoads, newBodyLoads);
#endif
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(Counters, CountersBlock, counters);

/// The relaxation of a mover's contacts: the largest with which their impulses converge. It is too large where a change
/// of the impulses is followed by the opposite change, at least nine tenths as large.
float relaxation(uint m, Field impulse, float acting)
{
    Field last = fetchField(lastMoverChanges, m);
    float relaxation = fetchRelaxation(lastMoverChanges, m);
#ifndef WARM_START
    Field before = fetchField(lastMoverImpulses, m);
    Field change = Field(impulse.t - before.t, impulse.f - before.f);
    float along = dot(change.t, last.t), size = dot(last.t, last.t);
    if (IS_BODY(m)) {
        float radius = max(bodyRadius(m), 1e-6), scale = 1.0 / (radius * radius);
        for (int column = 0; column < 3; ++column) {
            along += scale * dot(change.f[column], last.f[column]);
            size += scale * dot(last.f[column], last.f[column]);
        }
    }
    relaxation = along < -0.9 * size ? max(0.8 * relaxation, 1.0) : min(1.05 * relaxation, MOST_RELAXATION);
    if (acting == 0.0) relaxation = INITIAL_RELAXATION;
    STORE_FIELD(moverChanges, m, change)
    STORE_RELAXATION(moverChanges, m, relaxation)
#endif
    return relaxation;
}

void main()
{
    uint m = MOVER_OF_THREAD;
    if (m >= MOVER_END) return;
    MoverInfo mover = fetchMover(m);
    if (!responds(m, mover.assembly)) return;
    Sum contacts = contactSum(mover, counters[0].listParity);
    float relaxed = relaxation(m, contacts.impulse, contacts.acting);
    STORE_FIELD(moverImpulses, m, contacts.impulse)
    if (contacts.impulse.t != vec3(0)) assemblies[mover.assembly].lastContact = counters[0].substep - 1u;

    Field prediction = fetchField(moverPredictions, m);
    Field others = particleSum(mover);
    float scale = contactScale(fetchCentre(m));
    Field impulse = Field(scale * contacts.impulse.t + others.t, scale * contacts.impulse.f + others.f);
    float splits = contacts.acting;
    if (IS_BODY(m)) {
        vec4 rotation = fetchRotation(m), delta = texelFetch(lastMoverRotationDeltas, int(m));
        RowSum rows = rowSum(m, quaternionProduct(delta, rotation));
        splits += rows.acting;
        impulse = Field(impulse.t + rows.impulse.t, impulse.f + rows.impulse.f);
#ifdef JOINTED
        if (hasJoints(m)) {
            MoverMove move = unpackMove(moverMoves[m]);
            BodyLoad load = loadOf(prediction, impulse, others.f + rows.impulse.f, move.shift, quaternionProduct(delta, rotation),
                                   mover.inverseMass, fetchMoments(m));
            STORE_BODY_LOAD(newBodyLoads, m, load)
            moverMoves[m] = packMove(MoverMove(move.shift, scale * splits / relaxed));
            return;
        }
#endif
        moverRotationDeltas[m] = matchedRotationDelta(prediction.f + impulse.f, rotation, delta);
    }
    moverMoves[m] = packMove(MoverMove(prediction.t + mover.inverseMass * impulse.t, scale * splits / relaxed));
}
