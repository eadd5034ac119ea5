// One thread a solid particle: the impulse of the fluid around it, opposite to the one that fluid_pressure gives to the
// fluid.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/solid_cells.glsl"

uniform samplerBuffer slotSolidImpulses;
layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, ParticleImpulses, particleImpulses);
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

/// The impulse of the fluid particle in a slot on a solid one: across its surface by what it covers, along it the share
/// by its weight of what all solids there receive.
vec3 impulseOf(SolidCell cell, uint slot)
{
    vec4 impulse = texelFetch(slotSolidImpulses, int(slot));
    if (impulse == vec4(0)) return vec3(0);
    vec3 offset = fetchPressurePosition(slot) - cell.centre;
    return -solidWeight(length(offset)) * impulse.xyz - impulse.w * cellCover(cell, offset).slope;
}

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint k = fetchParticleSlot(i), count = fetchCounts(k).fluids;
    SolidCell cell = fetchSolidCell(k);
    vec3 impulse = vec3(0);
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = fetchNeighbours(texel);
        impulse += impulseOf(cell, slots.x) + impulseOf(cell, slots.y);
        impulse += impulseOf(cell, slots.z) + impulseOf(cell, slots.w);
    }
    if (impulse == vec3(0)) return;
    // Like contacts, this makes its assembly end the substep by first order.
    assemblies[fetchParticle(i).assembly].lastContact = counters[0].substep - 1u;
    particleImpulses[fetchRank(i).rank].xyz += impulse;
}
