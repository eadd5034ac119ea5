// One thread a puppet that is to be caught, before the rest of a substep: from its time on it is driven to its clips,
// which are put where it is; when all of it is near them, it is animated again.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_poses.glsl"
#include "sim/common/bodies/puppet_states.glsl"
#include "sim/drive/turns.glsl"
#include "shared/animation_types.h"

layout(local_size_x = GROUP_SIZE) in;
READ_BUFFER(Puppet, Puppets, puppets);
READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uvec4, PuppetStates, puppetStates);
BUFFER(vec4, CatchOffsets, catchOffsets);
BUFFER(uint, MoverStates, newMoverStates);
BUFFER(uvec2, BodyReleases, bodyReleases);
uniform usamplerBuffer caughtReleases;   // per animated body: its place in bodyReleases, when it is let go again
uniform usamplerBuffer limpSubsteps;
uniform usamplerBuffer puppetOrder;      // of animated bodies, parents before what hangs on them
uniform samplerBuffer clipBodyTurns;
#include "sim/drive/catch_place.glsl"

bool isNear(Puppet puppet)
{
    for (uint k = puppet.firstBody; k < puppet.firstBody + puppet.bodyCount; ++k)
        if (distance(ownPlace(k).centre, clipPlace(k).centre) > puppet.catchNear) return false;
    return true;
}

/// Animates the puppet from now on; its difference from its clip fades.
void take(Puppet puppet)
{
    for (uint k = puppet.firstBody; k < puppet.firstBody + puppet.bodyCount; ++k) {
        AnimatedBody at = animatedBodies[k];
        Place is = ownPlace(k), clip = clipPlace(k);
        vec4 turn = quaternionProduct(is.rotation, conjugate(clip.rotation));
        if (at.parent != NONE) turn = turnFrom(texelFetch(clipBodyTurns, int(k)), ownPlace(at.parent).rotation,
                                               is.rotation);
        catchOffsets[2u * k] = turn;
        catchOffsets[2u * k + 1u].xyz = is.centre - clip.centre;
        newMoverStates[at.mover] = MOVER_ANIMATED;
        uvec2 again = texelFetch(caughtReleases, int(k)).xy;
        if (again.x != NONE) bodyReleases[again.x].y = again.y;
    }
}

void main()
{
    uint p = gl_GlobalInvocationID.x;
    if (p >= sim.puppetCount) return;
    Puppet puppet = puppets[p];
    PuppetState s = PUPPET_STATE_FROM(puppetStates[2u * p], puppetStates[2u * p + 1u]);
    uint substep = counters[0].substep, root = texelFetch(puppetOrder, int(puppet.firstBody)).x;
    uint phase = s.phase;
    if (phase == PUPPET_FIRST && substep >= puppet.catchSubstep) {
        phase = PUPPET_FOUND;
        s.knocked = 0u;
    } else if (phase == PUPPET_FOUND) {
        phase = PUPPET_CATCHING;
        if (puppet.catchHere == 1u) putHere(puppet, root, s);
    } else if (phase == PUPPET_CATCHING) {
        bool late = float(substep - s.since) * sim.substepTime > puppet.catchWithin;
        if (late) phase = puppet.catchOtherwise == OTHERWISE_ANIMATED ? PUPPET_CAUGHT : PUPPET_MISSED;
        if (late && puppet.catchOtherwise == OTHERWISE_LIMP) s.knocked = 1u;
        if (isNear(puppet)) phase = PUPPET_CAUGHT;
        if (substep >= texelFetch(limpSubsteps, int(root)).y) phase = PUPPET_MISSED;
        if (phase == PUPPET_CAUGHT) take(puppet);
    }
    if (phase == s.phase) return;
    s.phase = phase;
    s.since = substep;
    STORE_PUPPET_STATE(puppetStates, p, s)
}
