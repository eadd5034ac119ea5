// One thread a particle, by rank: clears the impulses on single particles (from fluids, ropes, soft bodies).
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, ParticleImpulses, particleImpulses);

void main()
{
    uint rank = gl_GlobalInvocationID.x;
    if (rank < sim.particleCount) particleImpulses[rank] = vec4(0);
}
