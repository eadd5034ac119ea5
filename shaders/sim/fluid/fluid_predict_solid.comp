// One thread a solid particle: its place for fluids, where its mover is predicted to bring it in the substep.
// RELAX: where it is.
#include "sim/common/kernel.glsl"
#include "sim/common/movers.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer masses;            // inverse mass
uniform samplerBuffer restOffsets;
uniform usamplerBuffer particleRanks;   // mover, rank
uniform usamplerBuffer particleSlots;
BUFFER(vec4, SlotPositions, slotPositions);    // w: mass [kg]

void main()
{
    if (gl_GlobalInvocationID.x >= sim.particleCount) return;
    int i = int(gl_GlobalInvocationID.x);
#ifdef RELAX
    vec3 x = texelFetch(positions, i).xyz;
#else
    MoverPoint point = moverPoint(texelFetch(particleRanks, i).x, texelFetch(restOffsets, i).xyz);
    vec3 x = point.centre + point.arm + point.move;
#endif
    slotPositions[texelFetch(particleSlots, i).x] = vec4(x, 1.0 / max(texelFetch(masses, i).x, 1e-20));
}
