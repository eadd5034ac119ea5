// One thread a puppet: the strength of the drives and pins of each of its bodies in the substep.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/bodies/puppet_states.glsl"
#include "shared/animation_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Puppet, Puppets, puppets);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(Counters, CountersBlock, counters);
uniform samplerBuffer strengthKeys;      // time [s], strength; 1: smooth
uniform usamplerBuffer limpSubsteps;     // when bodies go limp; the same after they were caught; when they are caught
uniform usamplerBuffer puppetOrder;
uniform samplerBuffer driveHits;         // strength of a body that a blow has taken
uniform samplerBuffer clipBodyPlaces;
BUFFER(float, DriveLevels, driveLevels);
BUFFER(uvec4, PuppetStates, puppetStates);
#ifdef SLEEP
BUFFER(uvec2, AssemblyCalm, assemblyCalm);   // steps, island
#endif

/// Strength by the puppet's keys.
float strengthAt(Puppet puppet, float time)
{
    if (puppet.keyCount == 0u) return 1.0;
    uint k = puppet.firstKey, last = k + puppet.keyCount - 1u;
    while (k < last && texelFetch(strengthKeys, int(k + 1u)).x <= time) ++k;
    vec4 before = texelFetch(strengthKeys, int(k)), next = texelFetch(strengthKeys, int(min(k + 1u, last)));
    float part = clamp((time - before.x) / max(next.x - before.x, 1e-6), 0.0, 1.0);
    if (before.z == 1.0) part = smoothstep(0.0, 1.0, part);
    return mix(before.y, next.y, part);
}

/// Stores the strength that blows have taken from each body, and with a falloff from its neighbours.
void spreadHits(Puppet puppet)
{
    uint first = puppet.firstBody, end = first + puppet.bodyCount;
    for (uint k = first; k < end; ++k) driveLevels[k] = texelFetch(driveHits, int(k)).x;
    for (uint i = end; i-- > first;) {
        uint k = texelFetch(puppetOrder, int(i)).x, parent = animatedBodies[k].parent;
        if (parent != NONE) driveLevels[parent] = max(driveLevels[parent], puppet.hitFalloff * driveLevels[k]);
    }
    for (uint i = first; i < end; ++i) {
        uint k = texelFetch(puppetOrder, int(i)).x, parent = animatedBodies[k].parent;
        if (parent != NONE) driveLevels[k] = max(driveLevels[k], puppet.hitFalloff * driveLevels[parent]);
    }
}

/// Whether a driven puppet's first body is too far from its clip.
bool isTornAway(Puppet puppet, PuppetState s, uint root, bool limp)
{
    uint m = animatedBodies[root].mover;
    if (limp || s.phase == PUPPET_FOUND || s.phase == PUPPET_CATCHING || !responds(m)) return false;
    return distance(fetchCentre(m), texelFetch(clipBodyPlaces, int(2u * root)).xyz) > puppet.knockDistance;
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.puppetCount) return;
    Puppet puppet = puppets[p];
    PuppetState s = PUPPET_STATE_FROM(puppetStates[2u * p], puppetStates[2u * p + 1u]);
    uint substep = counters[0].substep, root = texelFetch(puppetOrder, int(puppet.firstBody)).x;
    bool caught = s.phase != PUPPET_FIRST;
    uvec2 rootLimp = texelFetch(limpSubsteps, int(root)).xy;
    if (isTornAway(puppet, s, root, substep >= (caught ? rootLimp.y : rootLimp.x)))
        puppetStates[2u * p].z = s.knocked = 1u;
    float strength = strengthAt(puppet, float(substep + 1u) * sim.substepTime);
    if (s.phase == PUPPET_FOUND) strength = 0.0;
    if (s.phase == PUPPET_CATCHING) strength *= easedPart(s, substep, puppet.catchBlend);
    spreadHits(puppet);
    bool acts = false;
    for (uint k = puppet.firstBody; k < puppet.firstBody + puppet.bodyCount; ++k) {
        uvec2 limp = texelFetch(limpSubsteps, int(k)).xy;
        bool isLimp = s.knocked == 1u || substep >= (caught ? limp.y : limp.x);
        driveLevels[k] = isLimp ? 0.0 : strength * (1.0 - driveLevels[k]);
        acts = acts || !isLimp;
    }
#ifdef SLEEP
    // A clip that keeps moving moves the bodies that are driven to it.
    uint assembly = fetchMover(animatedBodies[root].mover).assembly;
    if (acts) assemblyCalm[assembly] = uvec2(0u, assembly);
#endif
}
