// One thread a particle: how long it has been in the scene at the end of the step [s]; 0 while it is not. Emitters then
// set that of what they let out (sim/emitter/fluid_emit.comp).
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(float, ParticleAges, particleAges);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount + sim.fluidCount) return;
    float age = particleAges[i] + float(sim.substeps) * sim.substepTime;
    particleAges[i] = texelFetch(positions, int(i)).w != 0.0 ? 0.0 : age;
}
