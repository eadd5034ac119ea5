// One thread a fluid particle: where it is predicted to be at the end of the step's first substep if no pressure acts;
// fluid_pressure says so for those that follow. RELAX: where it is.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_living.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer velocities;
uniform samplerBuffer masses;            // inverse mass
uniform usamplerBuffer particleSlots;
BUFFER(vec4, SlotPositions, slotPositions);    // w: mass [kg]

void main()
{
    if (gl_GlobalInvocationID.x >= sim.fluidCount) return;
    int i = int(sim.particleCount + gl_GlobalInvocationID.x);
    vec4 place = texelFetch(positions, i);
    if (isInactive(place)) return;
#ifdef RELAX
    vec3 x = place.xyz;
#else
    vec3 x = predictedPosition(place.xyz, texelFetch(velocities, i).xyz);
#endif
    slotPositions[texelFetch(particleSlots, i).x] = vec4(x, 1.0 / max(texelFetch(masses, i).x, 1e-20));
}
