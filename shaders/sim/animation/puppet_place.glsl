// Where a caught puppet's clips are put, and how it gets to where they have it.
#include "sim/animation/clip_mix.glsl"
#include "sim/common/bodies/puppet_states.glsl"

uniform usamplerBuffer puppetStates;
uniform samplerBuffer catchOffsets;   // per animated body two: the turn by which it differed; the first's offset [m]

PuppetState fetchPuppet(uint puppet)
{
    int first = int(2u * puppet);
    return PUPPET_STATE_FROM(texelFetch(puppetStates, first), texelFetch(puppetStates, first + 1));
}

/// The part of a turn that is left. @param left 1: all of it.
vec4 leftOf(vec4 turn, float left)
{
    if (turn.w < 0.0) turn = -turn;
    return normalize(mix(vec4(0, 0, 0, 1), turn, left));
}

/// The part that is left of a puppet's difference from its clip when it was caught; none while it is driven.
float leftAt(PuppetState s, uint substep)
{
    return s.phase == PUPPET_CAUGHT ? 1.0 - easedPart(s, substep, CATCH_SETTLE) : 0.0;
}

/// The place of a clip after its puppet was caught.
Placed putByCatch(PuppetState s, Placed p)
{
    vec4 turn = aboutY(s.yaw);
    return Placed(rotate(turn, p.place) + s.shift, quaternionProduct(turn, p.turned));
}

/// Adds what is left of the first body's offset. @param centre its own. @param first its index.
Placed offsetBy(Placed p, vec3 centre, uint first, float left)
{
    vec4 turn = leftOf(texelFetch(catchOffsets, int(2u * first)), left);
    vec3 way = left * texelFetch(catchOffsets, int(2u * first + 1u)).xyz;
    return Placed(rotate(turn, p.place - centre) + centre + way, quaternionProduct(turn, p.turned));
}
