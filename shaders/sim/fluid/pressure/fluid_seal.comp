// One thread a solid particle: its share of what fluid lacks around its body.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/pressure/body_wets.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, ParticleImpulses, particleImpulses);

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= sim.particleCount) return;
    ParticleRank rank = fetchRank(i);
    if (rank.mover >= sim.bodyCount) return;
    particleImpulses[rank.rank].xyz += fetchBodySeal(rank.mover) * fetchParticleWet(rank.rank).seal;
}
