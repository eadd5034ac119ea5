// One thread a mover: its velocity and place at the end of the substep. BDF2 where the prediction was and nothing has
// touched since (second order would answer a shock one and a half times), else move / h.
#include "sim/common/kernel.glsl"
#include "sim/common/fields.glsl"
#include "math/quaternion.glsl"
#include "sim/common/links.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverMoves;
uniform samplerBuffer moverRotationDeltas;
uniform samplerBuffer lastMoverCentres;
uniform samplerBuffer lastMoverRotations;
uniform samplerBuffer lastMoverVelocities;
uniform samplerBuffer lastOldMoverMoves;
uniform samplerBuffer bodyMoments;
uniform usamplerBuffer moverInfo;
uniform usamplerBuffer assemblyState;
uniform usamplerBuffer rankedParticles;
uniform usamplerBuffer bodyInfo;
BUFFER(vec4, MoverCentres, moverCentres);
BUFFER(vec4, MoverRotations, moverRotations);
BUFFER(vec4, MoverVelocities, moverVelocities);
BUFFER(vec4, OldMoverVelocities, oldMoverVelocities);
BUFFER(vec4, OldMoverMoves, oldMoverMoves);
BUFFER(Counters, CountersBlock, counters);

/// The moves of a mover's particles: (turn - 1) of each column of its rotation.
Field moveOf(uint m, vec4 rotation, vec4 turn)
{
    Field move = Field(texelFetch(moverMoves, int(m)).xyz, mat3(0));
    if (!IS_BODY(m)) return move;
    mat3 axes = matrixFromQuaternion(rotation);
    for (int column = 0; column < 3; ++column) {
        vec3 t = 2.0 * cross(turn.xyz, axes[column]);
        move.f[column] = turn.w * t + cross(turn.xyz, t);
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

void main()
{
    uint m = MOVER_OF_THREAD;
    if (m >= MOVER_END) return;
    uvec4 info = texelFetch(moverInfo, int(m));
    if (uintBitsToFloat(info.w) == 0.0) return;
    if (isAsleep(info.z)) {
        Field rest = Field(vec3(0), mat3(0));
        STORE_FIELD(oldMoverMoves, m, rest)
        STORE_FIELD(oldMoverVelocities, m, rest)
        STORE_FIELD(moverVelocities, m, rest)
        return;
    }
    uvec2 state = texelFetch(assemblyState, int(info.z)).xy;
    vec4 rotation = texelFetch(lastMoverRotations, int(m)), turn = texelFetch(moverRotationDeltas, int(m));
    Field move = moveOf(m, rotation, turn);
    Field last = fetchField(lastOldMoverMoves, m), velocity = fetchField(lastMoverVelocities, m);
    float radius = IS_BODY(m) ? texelFetch(bodyMoments, int(3u * m)).w : 0.0;
    Field next = velocityOf(move, last, state.y == 2u && state.x + 1u != counters[0].substep);

    float speed = fastestOf(next, radius);
    float slow = min(1.0, sim.maxSpeed / max(speed, 1e-20));
    next = Field(slow * next.t, slow * next.f);
    if (isnan(speed) || isinf(speed)) {
        atomicOr(counters[0].problems, PROBLEM_NAN);
        uint particle = IS_BODY(m) ? fetchLink(texelFetch(bodyInfo, int(m)).x).particle
                                           : texelFetch(rankedParticles, int(info.x)).x;
        atomicMax(counters[0].badParticle, particle);
    }
    STORE_FIELD(oldMoverMoves, m, move)
    STORE_FIELD(oldMoverVelocities, m, velocity)
    STORE_FIELD(moverVelocities, m, next)
    moverCentres[m] = vec4(texelFetch(lastMoverCentres, int(m)).xyz + move.t, 0);
    moverRotations[m] = normalize(quaternionProduct(turn, rotation));
}
