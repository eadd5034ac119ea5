// One thread a slot: what the fluid around presses its solid particle with, against what fluid_push gives to the fluid.
#include "shared/kernel.glsl"
#include "shared/fluid_slots.glsl"
#include "shared/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotPlaces;
uniform samplerBuffer slotPressures;     // place, lambda
uniform samplerBuffer slotSolids;        // gradient; w: one over the weights of all solid particles there
uniform usamplerBuffer particlePlaces;   // mover, rank
uniform usamplerBuffer particleInfo;
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(uvec2, AssemblyState, assemblyState);   // last substep with a contact
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = texelFetch(slotParticles, int(k)).x;
    if (isFluid(i)) return;
    uint count = texelFetch(slotCounts, int(k)).x;
    vec3 x = texelFetch(slotPlaces, int(k)).xyz, impulse = vec3(0);
    for (uint n = 0u; n < count; ++n) {
        uint slot = fluidNeighbour(k, n);
        vec4 fluid = texelFetch(slotPressures, int(slot)), solid = texelFetch(slotSolids, int(slot));
        impulse -= solidWeight(length(fluid.xyz - x)) * solid.w * fluid.w * solid.xyz;
    }
    if (impulse == vec3(0)) return;
    // As contacts do: its assembly ends the substep to first order.
    assemblyState[texelFetch(particleInfo, int(i)).z].x = counters[0].substep - 1u;
    particleImpulses[texelFetch(particlePlaces, int(i)).y].xyz += impulse;
}
