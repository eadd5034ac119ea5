// One thread a mover: its velocity, and where it is at the end of the substep. BDF2 where the prediction used it and
// nothing has touched the assembly since, else move / h: second order would answer a collision one and a half times.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/links.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/nan_report.glsl"
#include "sim/common/particles.glsl"

layout(local_size_x = GROUP_SIZE) in;
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

/// The moves of a mover's particles: what its rotation delta changes in each column of its rotation.
Field moveField(uint m, vec4 rotation, vec4 delta)
{
    Field move = Field(fetchMove(m).shift, mat3(0));
    if (!IS_BODY(m)) return move;
    mat3 axes = matrixFromQuaternion(rotation);
    for (int column = 0; column < 3; ++column) {
        vec3 t = 2.0 * cross(delta.xyz, axes[column]);
        move.f[column] = delta.w * t + cross(delta.xyz, t);
    }
    return move;
}

/// The velocity of move and the last move: BDF2's, or first order.
Field velocityOf(Field move, Field last, bool second)
{
    float a = (second ? 1.5 : 1.0) * sim.damping / sim.substepTime;
    float b = (second ? -0.5 : 0.0) * sim.damping / sim.substepTime;
    return Field(a * move.t + b * last.t, a * move.f + b * last.f);
}

#ifdef JOINTED
/// Of how the axes of a jointed body turn, the part that one Newton step of its tree can follow.
float followedPart(mat3 f)
{
    const float MOST_TURN = 0.4;   // in a substep [rad]
    float turn = sim.substepTime * sqrt(0.5 * (dot(f[0], f[0]) + dot(f[1], f[1]) + dot(f[2], f[2])));
    return min(1.0, MOST_TURN / max(turn, 1e-20));
}
#endif

void main()
{
    uint m = MOVER_OF_THREAD;
    if (m >= MOVER_END) return;
    if (isFixed(m)) return;
    MoverInfo mover = fetchMover(m);
    if (isAsleep(mover.assembly)) {
        Field rest = Field(vec3(0), mat3(0));
        STORE_FIELD(oldMoverMoves, m, rest)
        STORE_FIELD(oldMoverVelocities, m, rest)
        STORE_FIELD(moverVelocities, m, rest)
        return;
    }
    Assembly assembly = fetchAssembly(mover.assembly);
    vec4 rotation = texelFetch(lastMoverRotations, int(m)), delta = fetchRotationDelta(m);
    Field move = moveField(m, rotation, delta);
    Field last = fetchField(lastOldMoverMoves, m), velocity = fetchField(lastMoverVelocities, m);
    float radius = IS_BODY(m) ? bodyRadius(m) : 0.0;
    bool touched = assembly.lastContact + 1u == counters[0].substep;
    Field next = velocityOf(move, last, assembly.order == 2u && !touched);

#ifdef JOINTED
    if (IS_BODY(m) && hasJoints(m)) next.f *= followedPart(next.f);
#endif
    float speed = fastestOf(next, radius);
    float slow = min(1.0, sim.maxSpeed / max(speed, 1e-20));
    next = Field(slow * next.t, slow * next.f);
    if (isnan(speed) || isinf(speed)) {
        uint particle = IS_BODY(m) ? fetchLink(fetchBody(m).linkStart).particle : fetchRankedParticle(mover.firstRank);
        REPORT_NAN(particle);
    }
#ifdef JOINTED
    // The next substep, of second order, goes on from what a joint's limit stopped, not from what it was before.
    if (assembly.order == 1u && !touched && assembly.lastContact + 2u != counters[0].substep) velocity = next;
#endif
    STORE_FIELD(oldMoverMoves, m, move)
    STORE_FIELD(oldMoverVelocities, m, velocity)
    STORE_FIELD(moverVelocities, m, next)
    nextCentres[m] = vec4(texelFetch(lastMoverCentres, int(m)).xyz + move.t, 0);
    nextRotations[m] = normalize(quaternionProduct(delta, rotation));
}
