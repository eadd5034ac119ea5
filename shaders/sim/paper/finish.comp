// One thread a particle: velocity and position at the end of the substep. BDF2 where the prediction was and nothing
// has touched since (second order would answer a shock one and a half times), else move / h. Bodies put their particles,
// so that they stay rigid whatever the iterations have left, and no rounding of moves adds up.
#include "sim/common/kernel.glsl"
#include "math/quaternion.glsl"
#include "sim/common/links.glsl"
#include "sim/common/sleep.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer predicted;
uniform samplerBuffer masses;
uniform usamplerBuffer particleInfo;
uniform usamplerBuffer assemblyState;
uniform samplerBuffer restOffsets;
uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
uniform usamplerBuffer particleLinks;
uniform usamplerBuffer linksOfParticle;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, OldMoves, oldMoves);
BUFFER(vec4, OldVelocities, oldVelocities);
BUFFER(Counters, CountersBlock, counters);

vec3 bodyPlace(uint body, vec3 r)
{
    return texelFetch(moverCentres, int(body)).xyz + rotate(texelFetch(moverRotations, int(body)), r);
}

/// The mean of the goals of a particle that bodies share, from the first, so that rounding stays as small as the gap.
vec3 meanPlace(uint i)
{
    uvec2 owned = texelFetch(particleLinks, int(i)).xy;
    vec3 first = vec3(0), shift = vec3(0);
    for (uint l = 0u; l < owned.y; ++l) {
        uvec2 owner = texelFetch(linksOfParticle, int(owned.x + l)).xy;
        vec3 place = bodyPlace(owner.y, fetchLink(owner.x).r);
        first = l == 0u ? place : first;
        shift += place - first;
    }
    return first + shift / float(owned.y);
}

void setVelocity(uint i, vec3 move, vec3 next)
{
    oldMoves[i] = vec4(move, 0);
    oldVelocities[i] = velocities[i];
    velocities[i] = vec4(next, 0);
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount || texelFetch(masses, int(i)).x == 0.0) return;
    uvec4 info = texelFetch(particleInfo, int(i));
    if (isAsleep(info.z)) {
        setVelocity(i, vec3(0), vec3(0));
        return;
    }
    vec3 move = texelFetch(predicted, int(i)).xyz;
    uvec2 state = texelFetch(assemblyState, int(info.z)).xy;
    bool second = state.y == 2u && state.x + 1u != counters[0].substep;
    vec3 next = (second ? 1.5 * move - 0.5 * oldMoves[i].xyz : move) / sim.substepTime;
    next *= sim.damping;
    next *= min(1.0, sim.maxSpeed / max(length(next), 1e-20));
    if (any(isnan(next)) || any(isinf(next))) {
        atomicOr(counters[0].problems, PROBLEM_NAN);
        atomicMax(counters[0].badParticle, i);
    }
    setVelocity(i, move, next);
    if (info.y == 0u) positions[i].xyz += move;
    else if (info.y == 1u) positions[i].xyz = bodyPlace(info.x, texelFetch(restOffsets, int(i)).xyz);
    else positions[i].xyz = meanPlace(i);
}
