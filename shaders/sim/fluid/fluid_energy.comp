// One thread a fluid particle: its kinetic and potential energy, added up by each work group.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/group_sum.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
BUFFER(float, FluidEnergySums, newFluidEnergySums);

void main()
{
    float energy = 0.0;
    if (gl_GlobalInvocationID.x < sim.fluidCount) {
        uint i = sim.particleCount + gl_GlobalInvocationID.x;
        vec3 x = texelFetch(positions, int(i)).xyz, v = texelFetch(velocities, int(i)).xyz;
        energy = (0.5 * dot(v, v) - dot(sim.gravity.xyz, x)) / max(fetchMass(i).inverseMass, 1e-20);
    }
    float sum = groupSum(energy);
    if (gl_LocalInvocationIndex == 0u) newFluidEnergySums[gl_WorkGroupID.x] = sum;
}
