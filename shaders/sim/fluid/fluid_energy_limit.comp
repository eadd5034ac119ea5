// One work group: tells the host if fluids have more energy than they had at the start plus what solids can have given
// them. START: notes the energy at the start.
#include "sim/common/kernel.glsl"
#include "sim/fluid/group_sum.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer fluidEnergySums;
BUFFER(float, FluidEnergyLimits, fluidEnergyLimits);
#ifndef START
BUFFER(Counters, CountersBlock, counters);
#endif

void main()
{
    uint count = (sim.fluidCount + GROUP_SIZE - 1u) / GROUP_SIZE;
    float part = 0.0;
    for (uint k = gl_LocalInvocationIndex; k < count; k += GROUP_SIZE)
        part += texelFetch(fluidEnergySums, int(k)).x;
    float energy = groupSum(part);
    if (gl_LocalInvocationIndex > 0u) return;
#ifdef START
    fluidEnergyLimits[0] = energy + fluidEnergyLimits[1];
#else
    if (energy > fluidEnergyLimits[0]) atomicOr(counters[0].problems, PROBLEM_FLUID_ENERGY);
#endif
}
