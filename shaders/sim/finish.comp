// One thread a particle: velocity and position at the end of the substep. BDF2 where the prediction was and nothing
// has touched since (second order would answer a shock one and a half times), else move / h.
#include "shared/kernel.glsl"
#include "shared/quaternion.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
uniform samplerBuffer masses;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer assemblyState;
uniform samplerBuffer restOffsets;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, OldMoves, oldMoves);
BUFFER(vec4, OldVelocities, oldVelocities);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= step.particleCount || texelFetch(masses, int(i)).x == 0.0) return;
    vec3 move = texelFetch(predicted, int(i)).xyz;
    uvec4 info = texelFetch(particleInfo, int(i));
    uvec2 state = texelFetch(assemblyState, int(info.z)).xy;
    bool second = state.y == 2u && state.x + 1u != counters[0].substep;
    vec3 next = (second ? 1.5 * move - 0.5 * oldMoves[i].xyz : move) / step.substepTime;
    next *= step.damping;
    next *= min(1.0, step.maxSpeed / max(length(next), 1e-20));
    if (any(isnan(next)) || any(isinf(next))) {
        atomicOr(counters[0].problems, PROBLEM_NAN);
        atomicMax(counters[0].badParticle, i);
    }
    oldMoves[i] = vec4(move, 0);
    oldVelocities[i] = velocities[i];
    velocities[i] = vec4(next, 0);
    // The paper's freezing (3.1): too small a move is not made, but its velocity is kept, so that it can grow.
    if (length(move) < step.freeze) return;
    // Of one body: placed by it, so that the rounding of moves never adds up.
    vec3 target = positions[i].xyz + move;
    if (info.y == 1u) {
        vec3 arm = rotate(texelFetch(moverRotations, int(info.x)), texelFetch(restOffsets, int(i)).xyz);
        target = texelFetch(moverCentres, int(info.x)).xyz + arm;
    }
    positions[i].xyz = target;
}
