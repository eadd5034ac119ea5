// One thread a particle: where its body has it (eq. 8), with which velocity.
#include "sim/common/kernel.glsl"
#include "sim/common/mover_state.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer masses;
uniform samplerBuffer restOffsets;
uniform usamplerBuffer particleRanks;   // mover, rank
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount || texelFetch(masses, int(i)).x == 0.0) return;
    PointState state = pointState(texelFetch(particleRanks, int(i)).x, texelFetch(restOffsets, int(i)).xyz);
    positions[i].xyz = state.position;
    velocities[i] = vec4(state.velocity, 0);
}
