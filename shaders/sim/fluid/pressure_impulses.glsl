// Impulses of fluid neighbours on a fluid particle.
#include "sim/fluid/fluid_materials.glsl"

/// The pressure impulse of the particle in another slot, in units of the kernel's steepness. s_corr (eq. 13) is a
/// fraction of the multipliers of particles that are too near to each other, added to them, so that it has no effect
/// where nothing is too dense.
vec3 pressureOf(SlotPressure own, float inverseReach, uint slot)
{
    SlotPressure other = fetchSlotPressure(slot);
    vec3 r = own.position - other.position;
    float a = 1.0 - min(sqrt(dot(r, r)) * inverseReach, 1.0), crowd = fluidShape(a), crowd2 = crowd * crowd;
    return (own.lambda + other.lambda) * (1.0 + FLUID_REPULSION * crowd2 * crowd2) * (a * a * a) * r;
}

/// Its surface tension impulse: particles of one fluid attract each other.
vec3 tensionOf(SlotPressure own, uint material, float tension, uint slot)
{
    vec3 offset = own.position - fetchSlotPressure(slot).position;
    float r = length(offset), same = fetchSlotMaterial(slot) == material ? 1.0 : 0.0;
    return -same * tension * fluidAttraction(min(r / sim.fluidReach, 1.0)) / max(r, 1e-9) * offset;
}

struct FluidImpulses {
    vec3 pressure;   // in units of the kernel's steepness
    vec3 tension;    // [kg m]; TENSION: of a world that has any
};

/// Sum of the impulses of the fluid neighbours of slot k.
FluidImpulses fluidImpulses(uint k, uint count, SlotPressure own)
{
    FluidImpulses sum = FluidImpulses(vec3(0), vec3(0));
    float inverseReach = 1.0 / sim.fluidReach;
#ifdef TENSION
    uint material = fetchSlotMaterial(k);
    float tension = fetchFluidMaterial(material).tension;
#endif
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = fetchNeighbours(texel);
        sum.pressure += pressureOf(own, inverseReach, slots.x);
        sum.pressure += pressureOf(own, inverseReach, slots.y);
        sum.pressure += pressureOf(own, inverseReach, slots.z);
        sum.pressure += pressureOf(own, inverseReach, slots.w);
#ifdef TENSION
        for (int c = 0; c < 4; ++c) sum.tension += tensionOf(own, material, tension, slots[c]);
#endif
    }
    return sum;
}
