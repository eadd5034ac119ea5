// One thread a slot: an iteration of Chebyshev's method for the velocities v of a substep's end,
//     m (v - goal) = sum of k r (r . (v_other - v)) + grip (v_wall - v),
// preconditioned by masses: each change is a sum of pair forces over masses, which keeps momentum however far it has
// come.
// The eigenvalues are 1 ... 1 + viscousStiffness. BACK: from slotOtherFlows to slotFlows, else the other way.
#include "sim/common/kernel.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"
#include "sim/fluid/viscous/viscous_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer viscousStiffness;
#ifdef BACK
uniform samplerBuffer slotOtherFlows;
BUFFER(vec4, SlotFlows, newFlows);
#define slotLastFlows slotOtherFlows
#else
uniform samplerBuffer slotFlows;
BUFFER(vec4, SlotOtherFlows, newFlows);
#define slotLastFlows slotFlows
#endif
layout(location = 0) uniform float iteration;

SlotFlow fetchSlotFlow(uint slot)
{
    return flowOf(texelFetch(slotLastFlows, int(slot)));
}

/// The impulse by a fluid neighbour.
vec3 impulseBy(uint slot, bool fluid, SlotStart start, SlotFlow own, float inverseReach)
{
    SlotStart there = fetchSlotStart(slot);
    SlotFlow other = fetchSlotFlow(slot);
    vec3 r = start.position - there.position;
    float squared = dot(r, r);
    float k = pairStrength(fluid, squared, inverseReach, own.thickness, other.thickness, there.grip);
    return k * dot(r, other.velocity - own.velocity) * r;
}

vec3 impulseOn(uint k, bool fluid, SlotFlow own)
{
    vec3 sum = vec3(0);
    SlotStart start = fetchSlotStart(k);
    NeighbourCounts counts = fetchCounts(k);
    float inverseReach = 1.0 / sim.fluidReach;
    NeighbourTexels texels = neighbourTexels(k, counts.fluids);
    do {
        uvec4 slots = texels.slots;
        sum += impulseBy(slots.x, fluid, start, own, inverseReach);
        sum += impulseBy(slots.y, fluid, start, own, inverseReach);
        sum += impulseBy(slots.z, fluid, start, own, inverseReach);
        sum += impulseBy(slots.w, fluid, start, own, inverseReach);
    } while (nextTexel(texels));
    for (uint n = 0u; fluid && n < counts.solids; ++n) {
        uint slot = fetchSolidNeighbour(k, n);
        vec3 r = start.position - fetchSlotStart(slot).position;
        sum += start.grip * solidShear(dot(r, r)) * dot(r, fetchSlotFlow(slot).velocity - own.velocity) * r;
    }
    SlotGrip wall = fetchSlotGrip(k);
    return sum + wall.grip * (wall.velocity - own.velocity);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    SlotGoal goal = fetchSlotGoal(k);
    SlotFlow own = fetchSlotFlow(k);
    vec3 left = goal.velocity - own.velocity;
    left += goal.inverseMass * impulseOn(k, isFluid(fetchSlotParticle(k)), own);
    float stiffness = uintBitsToFloat(texelFetch(viscousStiffness, 0).x), root = sqrt(1.0 + stiffness);
    vec3 next = own.velocity + left / (1.0 + 0.5 * stiffness);
    if (iteration > 0.0) {
        // The ratio of two of Chebyshev's polynomials.
        float ratio = (root - 1.0) / (root + 1.0), square = ratio * ratio, power = pow(square, iteration);
        vec3 before = newFlows[k].xyz;
        next = before + (1.0 + square) * (1.0 + power) / (1.0 + power * square) * (next - before);
    }
    newFlows[k] = pack(SlotFlow(next, own.thickness));
}
