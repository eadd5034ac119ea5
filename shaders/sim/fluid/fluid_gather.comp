// One thread a slot: the velocity and material of its particle, and how strongly viscosity smooths its velocity.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_materials.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer velocities;
BUFFER(uint, SlotMaterials, newSlotMaterials);
BUFFER(vec4, SlotVelocities, newSlotVelocities);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k), material = fetchParticle(i).material;
    newSlotMaterials[k] = material;
    float smoothing = fetchFluidMaterial(material).smoothing;
    newSlotVelocities[k] = pack(SlotVelocity(texelFetch(velocities, int(i)).xyz, smoothing));
}
