// One thread a joint or an end of a rope that lets go at a time: its assembly is awake in the step in which it does.
#include "sim/common/kernel.glsl"
#include "sim/sleep/calm.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer sleepReleases;    // assembly, and the first substep after it has let go
BUFFER(Calm, AssemblyNext, assemblyNext);
READ_BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= uint(textureSize(sleepReleases))) return;
    uvec2 release = texelFetch(sleepReleases, int(k)).xy;
    uint next = counters[0].substep;
    if (release.y >= next && release.y <= next + sim.substeps) assemblyNext[release.x].steps = 0u;
}
