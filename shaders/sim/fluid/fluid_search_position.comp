// One thread a particle: the place for which the neighbours of fluids are found, on its way in the middle of the step.
#include "sim/common/kernel.glsl"
#include "sim/common/mover_state.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
uniform samplerBuffer restOffsets;
uniform usamplerBuffer particleRanks;   // mover, rank
BUFFER(vec4, FluidSearchPositions, fluidSearchPositions);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount + sim.fluidCount) return;
    float time = sim.lookAhead * sim.substepTime;
    vec4 place = texelFetch(positions, int(i));
    vec3 x = place.xyz, v = texelFetch(velocities, int(i)).xyz;
    if (i < sim.particleCount) {
        PointState state = pointState(texelFetch(particleRanks, int(i)).x, texelFetch(restOffsets, int(i)).xyz);
        x = state.position;
        v = state.velocity;
    }
    fluidSearchPositions[i] = vec4(x + time * v, place.w);   // w: whether it is parked
}
