// One thread a slot: how velocities change with place around its fluid particle, by differences to its neighbours and
// the inverse of their moments (Randles and Libersky 1996). fluid_viscosity takes that much from what it smooths.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_materials.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/fluid.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(uvec4, SlotGradients, newSlotGradients);

/// Sums over fluid neighbours, in units of the kernel's height and steepness: the fraction of the kernel, its moments:
/// the diagonal and yz, zx, xy, and the same of the velocities.
struct Sums {
    float fraction;
    vec3 diagonal, mixed;
    mat3 slope;
};

void add(inout Sums sums, vec3 x, vec3 velocity, float inverseReach, uint slot)
{
    vec3 r = x - fetchSlotPosition(slot).position, v = velocity - fetchSlotVelocity(slot).velocity;
    float a = 1.0 - min(sqrt(dot(r, r)) * inverseReach, 1.0);
    vec3 slope = a * a * a * r;
    sums.fraction += fluidShape(a);
    sums.diagonal += slope * r;
    sums.mixed += slope.yzx * r.zxy;
    sums.slope += outerProduct(v, slope);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint count = fetchFluidCounts(k, fetchSlotParticle(k)).fluids;
    vec3 x = fetchSlotPosition(k).position, velocity = fetchSlotVelocity(k).velocity;
    // A list whose length is not a multiple of four ends with the slot itself, which is subtracted again.
    Sums sums = Sums(1.0 - float(-count & 3u), vec3(0), vec3(0), mat3(0));
    float inverseReach = 1.0 / sim.fluidReach, steepness = -fluidSteepness();
    for (uint n = 0u, texel = neighbourTexel(k, 0u); n < count; n += 4u, texel += NEIGHBOUR_BLOCK) {
        uvec4 slots = fetchNeighbours(texel);
        for (int c = 0; c < 4; ++c) add(sums, x, velocity, inverseReach, slots[c]);
    }
    vec3 d = steepness * sums.diagonal, m = steepness * sums.mixed;
    // Where neighbours lack, velocities are taken to change less.
    float lacking = 0.1 * max(1.0 - sim.fluidVolume * sums.fraction, 0.0) + 0.005;
    mat3 moment = mat3(d.x, m.z, m.y, m.z, d.y, m.x, m.y, m.x, d.z) + mat3(lacking);
    float even = fetchFluidMaterial(fetchSlotMaterial(k)).evenSmoothing;
    newSlotGradients[k] = pack(SlotGradient(even * steepness * sums.slope * inverse(moment)));
}
