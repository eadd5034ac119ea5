// One thread a slot: the velocity and material of its particle, and how strongly its fluid's neighbours even theirs out.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer velocities;
uniform samplerBuffer fluidMaterials;    // smoothing
uniform usamplerBuffer particleInfo;
BUFFER(uint, SlotMaterials, slotMaterials);
BUFFER(vec4, SlotVelocities, slotVelocities);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    int i = int(texelFetch(slotParticles, int(k)).x);
    uint material = texelFetch(particleInfo, i).w;
    slotMaterials[k] = material;
    float smoothing = texelFetch(fluidMaterials, int(material)).x;
    slotVelocities[k] = vec4(texelFetch(velocities, i).xyz, smoothing);
}
