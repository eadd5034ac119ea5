// One thread a slot: a bound of how stiff viscosity is around its particle. Of L v = sum of k r (r . (v - v_other)) no
// eigenvalue is larger than twice the largest of the sums of k r r^T.
#include "sim/common/kernel.glsl"
#include "sim/fluid/viscous/viscous_slots.glsl"
#include "sim/fluid/viscous/viscous_pairs.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer slotFlows;
BUFFER(uint, ViscousStiffness, viscousStiffness);

/// A symmetric matrix: its diagonal, and yz, zx, xy.
struct Stiffness {
    vec3 diagonal, others;
};

void add(inout Stiffness sum, float k, vec3 r)
{
    sum.diagonal += k * r * r;
    sum.others += k * r.yzx * r.zxy;
}

/// An upper bound of the largest eigenvalue.
float bound(Stiffness s)
{
    vec3 o = abs(s.others), rows = s.diagonal + o.yzx + o.zxy;
    return max(rows.x, max(rows.y, rows.z));
}

float thicknessOf(uint slot)
{
    return flowOf(texelFetch(slotFlows, int(slot))).thickness;
}

Stiffness stiffnessAround(uint k, bool fluid)
{
    Stiffness sum = Stiffness(vec3(0), vec3(0));
    SlotStart own = fetchSlotStart(k);
    NeighbourCounts counts = fetchCounts(k);
    float inverseReach = 1.0 / sim.fluidReach, thickness = thicknessOf(k);
    NeighbourTexels texels = neighbourTexels(k, counts.fluids);
    do {
        uvec4 slots = texels.slots;
        for (int c = 0; c < 4; ++c) {
            SlotStart other = fetchSlotStart(slots[c]);
            vec3 r = own.position - other.position;
            float squared = dot(r, r);
            add(sum, pairStrength(fluid, squared, inverseReach, thickness, thicknessOf(slots[c]), other.grip), r);
        }
    } while (nextTexel(texels));
    for (uint n = 0u; fluid && n < counts.solids; ++n) {
        vec3 r = own.position - fetchSlotStart(fetchSolidNeighbour(k, n)).position;
        add(sum, own.grip * solidShear(dot(r, r)), r);
    }
    return sum;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    float stiffness = 2.0 * bound(stiffnessAround(k, isFluid(fetchSlotParticle(k)))) + fetchSlotGrip(k).grip;
    atomicMax(viscousStiffness[0], floatBitsToUint(stiffness * fetchSlotGoal(k).inverseMass));
}
