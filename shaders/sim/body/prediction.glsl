// How far a mover would move in the substep if nothing touched it.
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/outside.glsl"

uniform samplerBuffer moverVelocities;
uniform samplerBuffer oldMoverVelocities;
uniform samplerBuffer oldMoverMoves;
uniform samplerBuffer moverImpulses;
uniform usamplerBuffer lastAssemblyState;
BUFFER(vec4, MoverPredictions, moverPredictions);   // field: the centre's move, A; with joints as loadOf() says
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, MoverRotationDeltas, moverRotationDeltas);
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

/// Whether a mover's substep is of second order, because nothing touched its assembly lately; stored if it responds.
bool beginOrder(uint m, uint assembly)
{
    if (!responds(m)) return false;
    uint lastContact = fetchAssembly(lastAssemblyState, assembly).lastContact, now = counters[0].substep;
    bool second = sim.secondOrder == 1u && now > 0u && lastContact + 1u != now;
    assemblies[assembly].order = second ? 2u : 1u;
    return second;
}

/// The last impulses of a mover's contacts, scaled for mass scaling.
Field lastContactImpulse(uint m)
{
    Field impulse = fetchField(moverImpulses, m);
    float scale = contactScale(fetchCentre(m));
    return Field(scale * impulse.t, scale * impulse.f);
}

/// Stores where a substep begins for a mover; a mover that does not respond stays. @param move of its centre.
void storeStart(uint m, vec3 move, vec4 delta)
{
    if (!responds(m)) {
        // Contacts and joints treat a mover whose mass is split over no impulse as immovable.
        moverMoves[m] = packMove(MoverMove(vec3(0), 0.0));
        moverRotationDeltas[m] = vec4(0, 0, 0, 1);
        return;
    }
    moverMoves[m].xyz = move;
    moverRotationDeltas[m] = delta;
}

/// First order continues along the chord of the last turn, which is a smaller turn: 1 - phi^2 of it. This factor makes
/// both equal: otherwise a rolling ball would stop.
float chordScale(mat3 chord)
{
    float size = dot(chord[0], chord[0]) + dot(chord[1], chord[1]) + dot(chord[2], chord[2]);   // 4 (1 - cos phi)
    return 1.0 / (1.0 - 0.5 * min(size, LONGEST_CHORD));
}

/// BDF2, or symplectic Euler. @param keepsTurning whether it turns on by as much as it turned, see chordScale().
Field predictedMove(uint m, bool second, bool keepsTurning)
{
    float h = sim.substepTime;
    vec3 outside = outsideAcceleration(m);
    Field v = fetchField(moverVelocities, m);
    if (!second) {
        if (keepsTurning) v.f *= chordScale(h * v.f);
        return Field(h * (v.t + h * outside), h * v.f);
    }
    Field move = fetchField(oldMoverMoves, m), last = fetchField(oldMoverVelocities, m);
    return Field(move.t / 3.0 + h * (8.0 * v.t - 2.0 * last.t + 4.0 * h * outside) / 9.0,
                 move.f / 3.0 + h * (8.0 * v.f - 2.0 * last.f) / 9.0);
}
