// One thread a solid particle: the impulse of the fluid around it, opposite to the one that fluid_pressure gives to the
// fluid. SEALS: notes what fluid_body_seal asks for, in a world of bodies and colliders.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/walls/solid_cells.glsl"

uniform samplerBuffer slotSolidImpulses;
layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, ParticleImpulses, particleImpulses);
#ifdef SEALS
BUFFER(vec4, ParticleWets, newParticleWets);
#endif
BUFFER(Assembly, AssemblyState, assemblies);
READ_BUFFER(Counters, CountersBlock, counters);

struct Sums {
    vec3 impulse, slope;
    vec3 sizes;   // of slopes: alone, times what pressure gives over them, times masses
};

/// The impulse of the fluid particle in a slot on a solid one: across its surface by what it covers, along it the share
/// by its weight of what all solids there receive.
void addFluid(inout Sums sums, SolidCell cell, uint slot)
{
    vec4 impulse = texelFetch(slotSolidImpulses, int(slot));
    vec3 offset = fetchPressurePosition(slot) - cell.centre;
    float r = length(offset);
    // Who is listed beyond that need not list the solid itself, and notes nothing.
    if (impulse == vec4(0) || r >= sim.fluidListReach) return;
    vec3 slope = cellCover(cell, offset).slope;
    sums.impulse -= solidWeight(r) * impulse.xyz + impulse.w * slope;
    float size = length(slope);
    sums.slope += slope;
    sums.sizes += size * vec3(1.0, impulse.w, fetchSlotPosition(slot).mass);
}

#ifdef SEALS
/// The directions out of colliders that the particle lies on, if no fluid gets between.
vec3 sealOf(uint k, vec3 x)
{
    vec3 seal = vec3(0);
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        ColliderSurface surface = colliderSurface(near.index, x);
        float gap = surface.distance - 0.5 * sim.diameter;
        seal += (1.0 - smoothstep(0.5, 1.2, gap / sim.fluidSpacing)) * surface.normal;
    }
    return seal;
}
#endif

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    uint k = fetchParticleSlot(i), count = fetchCounts(k).fluids;
    SolidCell cell = fetchSolidCell(k);
    Sums sums = Sums(vec3(0), vec3(0), vec3(0));
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) addFluid(sums, cell, slots[c]);
    } while (nextTexel(texels));
    uint rank = fetchRank(i).rank;
#ifdef SEALS
    newParticleWets[3u * rank] = vec4(sums.slope, sums.sizes.x);
    newParticleWets[3u * rank + 1u] = vec4(sums.impulse, sums.sizes.y);
    newParticleWets[3u * rank + 2u] = vec4(sealOf(k, cell.centre), sums.sizes.z);
#endif
    if (sums.impulse == vec3(0)) return;
    // Like contacts, this makes its assembly end the substep by first order.
    assemblies[fetchParticle(i).assembly].lastContact = counters[0].substep - 1u;
    particleImpulses[rank].xyz += sums.impulse;
}
