// A mover's velocity and place at the end of the substep. BDF2 if the prediction used it and nothing has touched the
// assembly since, else move / h: second order would answer a collision one and a half times.
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/nan_report.glsl"
#include "sim/common/particles.glsl"

uniform samplerBuffer lastMoverCentres;
uniform samplerBuffer lastMoverRotations;
uniform samplerBuffer lastMoverVelocities;
uniform samplerBuffer lastOldMoverMoves;
BUFFER(vec4, MoverCentres, nextCentres);
BUFFER(vec4, MoverRotations, nextRotations);
BUFFER(vec4, MoverVelocities, moverVelocities);
BUFFER(vec4, OldMoverVelocities, oldMoverVelocities);
BUFFER(vec4, OldMoverMoves, oldMoverMoves);
BUFFER(Counters, CountersBlock, counters);

/// The moves of a mover's particles: the changes that its rotation delta makes to the columns of its rotation.
Field moveField(uint m, vec4 rotation, vec4 delta)
{
    Field move = Field(fetchMove(m).shift, mat3(0));
    if (!IS_BODY(m)) return move;
    move.f = turnOfAxes(rotation, delta);
    return move;
}

/// The velocity of move and the last move: BDF2's, or first order.
Field velocityOf(Field move, Field last, bool second)
{
    float a = (second ? 1.5 : 1.0) * sim.damping / sim.substepTime;
    float b = (second ? -0.5 : 0.0) * sim.damping / sim.substepTime;
    return Field(a * move.t + b * last.t, a * move.f + b * last.f);
}

/// A substep of one mover.
struct Motions {
    vec4 rotation, delta;   // when it began, and since
    Field move;             // of the substep
    Field before, next;     // velocities: when it began, and now
    Assembly assembly;
    bool touched;           // in this substep
};

Motions motionsOf(uint m, Assembly assembly)
{
    vec4 rotation = texelFetch(lastMoverRotations, int(m)), delta = fetchRotationDelta(m);
    Field move = moveField(m, rotation, delta);
    bool touched = assembly.lastContact + 1u == counters[0].substep;
    bool second = !responds(m) || (assembly.order == 2u && !touched);   // animated movers do not answer to touch
    Field next = velocityOf(move, fetchField(lastOldMoverMoves, m), second);
    return Motions(rotation, delta, move, fetchField(lastMoverVelocities, m), next, assembly, touched);
}

/// Limits its speed and stores where it is and how it moves.
void finish(uint m, Mover mover, Motions s)
{
    float speed = fastestOf(s.next, IS_BODY(m) ? bodyRadius(m) : 0.0);
    float slow = min(1.0, sim.maxSpeed / max(speed, 1e-20));
    Field next = Field(slow * s.next.t, slow * s.next.f);
    if (isnan(speed) || isinf(speed)) {
        uint particle = IS_BODY(m) ? fetchLink(fetchBody(m).linkStart).particle : fetchRankedParticle(mover.firstRank);
        REPORT_NAN(particle);
    }
    // A substep of first order without a touch was stopped by a joint's limit: the next one, of second order, continues
    // from the velocity after it, not from that before.
    bool stopped = s.assembly.order == 1u && !s.touched && s.assembly.lastContact + 2u != counters[0].substep;
    Field before = s.before;
    if (sim.jointTreeCount > 0u && stopped) before = next;
    STORE_FIELD(oldMoverMoves, m, s.move)
    STORE_FIELD(oldMoverVelocities, m, before)
    STORE_FIELD(moverVelocities, m, next)
    nextCentres[m] = texelFetch(lastMoverCentres, int(m)) + vec4(s.move.t, 0);
    nextRotations[m] = normalize(quaternionProduct(s.delta, s.rotation));
}

/// Sets the velocity of a mover at rest to zero.
void rest(uint m)
{
    Field none = Field(vec3(0), mat3(0));
    STORE_FIELD(oldMoverMoves, m, none)
    STORE_FIELD(oldMoverVelocities, m, none)
    STORE_FIELD(moverVelocities, m, none)
}
