// Impulses of fluid neighbours on a fluid particle.
#include "sim/fluid/fluid_materials.glsl"

/// The impulse that the pressure of the particle in another slot gives, in units of the kernel's steepness and of
/// lambdaUnit(), and what the own pressure acts by.
struct PairImpulse {
    vec3 byOther, slope;
};

void addPressure(inout PairImpulse sum, vec3 x, float inverseReach, uint slot)
{
    SlotPressure other = fetchSlotPressure(slot);
    vec3 r = x - other.position;
    float a = 1.0 - min(sqrt(dot(r, r)) * inverseReach, 1.0);
    vec3 slope = a * a * a * r;
    sum.byOther += other.lambda * slope;
    sum.slope += slope;
}

/// Its surface tension impulse: particles of one fluid attract each other.
vec3 tensionOf(SlotPressure own, uint material, float tension, uint slot)
{
    vec3 offset = own.position - fetchPressurePosition(slot);
    float r = length(offset), same = fetchSlotMaterial(slot) == material ? 1.0 : 0.0;
    return -same * tension * fluidAttraction(min(r / sim.fluidReach, 1.0)) / max(r, 1e-9) * offset;
}

struct FluidImpulses {
    vec3 pressure;   // [kg m]
    vec3 tension;    // [kg m]; TENSION: of a world that has any
};

/// Sum of the impulses of the fluid neighbours of slot k.
FluidImpulses fluidImpulses(uint k, uint count, SlotPressure own)
{
    PairImpulse pairs = PairImpulse(vec3(0), vec3(0));
    vec3 pulled = vec3(0);
    float inverseReach = 1.0 / sim.fluidReach;
#ifdef TENSION
    uint material = fetchSlotMaterial(k);
    float tension = fetchFluidMaterial(material).tension;
#endif
    NeighbourTexels texels = neighbourTexels(k, count);
    do {
        uvec4 slots = texels.slots;
        addPressure(pairs, own.position, inverseReach, slots.x);
        addPressure(pairs, own.position, inverseReach, slots.y);
        addPressure(pairs, own.position, inverseReach, slots.z);
        addPressure(pairs, own.position, inverseReach, slots.w);
#ifdef TENSION
        for (int c = 0; c < 4; ++c) pulled += tensionOf(own, material, tension, slots[c]);
#endif
    } while (nextTexel(texels));
    return FluidImpulses(lambdaUnit() * fluidSteepness() * (pairs.byOther + own.lambda * pairs.slope), pulled);
}

struct PressureImpulse {
    vec3 all;        // on the particle [kg m]
    vec3 bySolids;   // the part of it that solids give along them, and get back
    float push;      // what they give across them, over the slopes that they cover with [kg m2]
};

/// What pressure gives a particle, by the impulses of its fluid neighbours, walls and solids. Behind these is fluid of
/// the same pressure. So across them comes as much again as what they cover; along them neighbours make up only a part
/// of what fluid on all sides would give: without the rest, fluid would sink along walls for ever.
PressureImpulse pressedBy(SlotPressure own, float covered, vec3 walls, SlotSolidCover solids,
                          vec3 pairs)
{
    float unit = lambdaUnit(), part = min(covered, 0.75);
    vec3 sides = walls + solids.gradient;
    vec3 normal = sides / max(length(sides), 1e-20), along = pairs - dot(pairs, normal) * normal;
    vec3 rest = FLUID_ALONG_WALLS * part / (1.0 - part) * along;
    float bySolids = length(solids.gradient), share = bySolids / max(bySolids + length(walls), 1e-20);
    float push = 2.0 * unit * evenAcross(own.lambda, solids.gradient);
    vec3 ofWalls = 2.0 * unit * own.lambda * walls;
    return PressureImpulse(pairs + rest + ofWalls + push * solids.gradient, share * rest, push);
}
