// One thread a puppet: how strong the drives and pins of each of its bodies are in the substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "shared/animation_types.h"
#include "shared/drive_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(GpuPuppet, Puppets, puppets);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(Counters, CountersBlock, counters);
uniform samplerBuffer strengthKeys;      // time [s], strength; 1: smooth
uniform usamplerBuffer limpSubsteps;
BUFFER(float, DriveLevels, driveLevels);
#ifdef SLEEP
BUFFER(uvec2, AssemblyCalm, assemblyCalm);   // steps, island
#endif

/// What its keys say.
float strengthAt(GpuPuppet puppet, float time)
{
    if (puppet.keyCount == 0u) return 1.0;
    uint k = puppet.firstKey, last = k + puppet.keyCount - 1u;
    while (k < last && texelFetch(strengthKeys, int(k + 1u)).x <= time) ++k;
    vec4 before = texelFetch(strengthKeys, int(k)), next = texelFetch(strengthKeys, int(min(k + 1u, last)));
    float part = clamp((time - before.x) / max(next.x - before.x, 1e-6), 0.0, 1.0);
    if (before.z == 1.0) part = part * part * (3.0 - 2.0 * part);
    return mix(before.y, next.y, part);
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.puppetCount) return;
    GpuPuppet puppet = puppets[p];
    uint substep = counters[0].substep;
    float strength = strengthAt(puppet, float(substep + 1u) * sim.substepTime);
    bool acts = false;
    for (uint b = puppet.firstBody; b < puppet.firstBody + puppet.bodyCount; ++b) {
        float level = substep >= texelFetch(limpSubsteps, int(b)).x ? 0.0 : strength;
        driveLevels[b] = level;
        acts = acts || level > 0.0;
    }
#ifdef SLEEP
    // A clip that goes on moves what is driven to it.
    uint assembly = fetchMover(animatedBodies[puppet.firstBody].mover).assembly;
    if (acts) assemblyCalm[assembly] = uvec2(0u, assembly);
#endif
}
