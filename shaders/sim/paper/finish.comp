// One thread a particle: velocity and position at the end of the substep. BDF2 if the prediction used it and nothing
// has touched the particle since (second order would answer a shock one and a half times), else move / h. Bodies place
// their particles, so that they stay rigid whatever error the iterations leave, and no rounding of moves adds up.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/nan_report.glsl"
#include "sim/common/particles.glsl"
#include "sim/common/bodies/shared_goals.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, OldMoves, oldMoves);
BUFFER(vec4, OldVelocities, oldVelocities);
BUFFER(Counters, CountersBlock, counters);

void setVelocity(uint i, vec3 move, vec3 next)
{
    oldMoves[i] = vec4(move, 0);
    oldVelocities[i] = velocities[i];
    velocities[i] = vec4(next, 0);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    Particle info = fetchParticle(i);
    if (!moves(fetchRank(i).mover)) {
        setVelocity(i, vec3(0), vec3(0));
        return;
    }
    vec3 move = texelFetch(predicted, int(i)).xyz;
    Assembly assembly = fetchAssembly(info.assembly);
    bool second = assembly.order == 2u && assembly.lastContact + 1u != counters[0].substep;
    vec3 next = (second ? 1.5 * move - 0.5 * oldMoves[i].xyz : move) / sim.substepTime;
    next *= sim.damping;
    next *= min(1.0, sim.maxSpeed / max(length(next), 1e-20));
    if (any(isnan(next)) || any(isinf(next))) {
        REPORT_NAN(i);
    }
    setVelocity(i, move, next);
    if (info.bodyCount == 0u) positions[i].xyz += move;
    else if (info.bodyCount == 1u) positions[i].xyz = pointState(info.body, fetchArm(i).r).position;
    else positions[i].xyz = meanGoal(i).position;
}
