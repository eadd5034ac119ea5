// One thread a particle: how far it would move in the substep if nothing touched it. BDF2 (second-order velocities) if
// nothing touched its assembly lately, else symplectic Euler. Asks for a new search if it would leave its margin.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mass_scaling.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/particles.glsl"
#include "sim/paper/predicted_moves.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer searchPositions;   // positions for which contacts were found
uniform samplerBuffer velocities;
uniform samplerBuffer oldMoves;
uniform samplerBuffer oldVelocities;
BUFFER(vec4, Predicted, newPredicted);
BUFFER(Assembly, AssemblyState, assemblies);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    bool free = responds(fetchRank(i).mover);
    float inverseMass = free ? fetchMass(i).inverseMass : 0.0;
    uint assembly = fetchParticle(i).assembly, now = counters[0].substep;
    bool second = free && sim.secondOrder == 1u && now > 0u && assemblies[assembly].lastContact + 1u != now;
    if (free) assemblies[assembly].order = second ? 2u : 1u;

    float h = sim.substepTime;
    vec3 v = texelFetch(velocities, int(i)).xyz;
    vec3 move = vec3(0);
    if (second) {
        vec3 lastMove = texelFetch(oldMoves, int(i)).xyz;
        vec3 lastV = texelFetch(oldVelocities, int(i)).xyz;
        move = lastMove / 3.0 + h * (8.0 * v - 2.0 * lastV + 4.0 * h * sim.gravity.xyz) / 9.0;
    } else if (free)
        move = h * (v + h * sim.gravity.xyz);
    vec3 start = texelFetch(positions, int(i)).xyz;
    newPredicted[i] = pack(PredictedMove(move, contactScale(start) * inverseMass));
    if (distance(start + move, texelFetch(searchPositions, int(i)).xyz) > sim.drift) counters[0].due = 1u;
}
