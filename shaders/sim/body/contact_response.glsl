// What contacts add to a mover, and the number of impulses over which its mass is split for them (Tonge et al. 2012,
// mass splitting). WARM_START: after a search, applies only their old impulses, as at the start of a substep.
#include "shared/contact_constants.h"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/contacts/impulse_sums.glsl"
#include "sim/common/contacts/stacks.glsl"

uniform samplerBuffer lastMoverImpulses;
uniform samplerBuffer lastMoverChanges;
BUFFER(vec4, MoverImpulses, moverImpulses);   // field: the sums of contacts
BUFFER(vec4, MoverChanges, moverChanges);     // field: their last changes; with the relaxation
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

/// The relaxation of a mover's contacts: the largest with which their impulses converge. It is too large if a change of
/// the impulses is followed by an opposite change at least nine tenths as large.
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
    // What its stack holds does not change within a substep, and so tells nothing.
    if (IS_BODY(m) && inStack(m)) relaxation = 1.0;
    STORE_FIELD(moverChanges, m, change)
    STORE_RELAXATION(moverChanges, m, relaxation)
#endif
    return relaxation;
}

struct ContactResponse {
    Field impulse;   // of all its contacts, scaled for mass scaling
    float splits;    // as in MoverMove
};

/// Sums and stores. @param others further impulses over which its mass is split.
ContactResponse contactResponse(uint m, Mover mover, float others)
{
    Sum contacts = contactSum(mover, counters[0].listParity);
    float relaxed = relaxation(m, contacts.impulse, contacts.acting);
    STORE_FIELD(moverImpulses, m, contacts.impulse)
    if (contacts.impulse.t != vec3(0)) assemblies[mover.assembly].lastContact = counters[0].substep - 1u;
    float scale = contactScale(fetchCentre(m));
    return ContactResponse(Field(scale * contacts.impulse.t, scale * contacts.impulse.f),
                           scale * (contacts.acting + others) / relaxed);
}
