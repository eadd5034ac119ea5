// Where shape matching wants a particle of a body.
#include "math/quaternion.glsl"

uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
uniform samplerBuffer moverMoves;        // of the centre since
uniform samplerBuffer moverRotationDeltas;

/// How far the goal of r has moved in the substep [m]. From the turn, not from two positions, so that rounding stays as
/// small as the move.
vec3 goalMove(uint body, vec3 r)
{
    vec3 arm = rotate(texelFetch(bodyStarts, int(2u * body + 1u)), r);
    vec4 turn = texelFetch(moverRotationDeltas, int(body));
    vec3 t = 2.0 * cross(turn.xyz, arm);
    return texelFetch(moverMoves, int(body)).xyz + turn.w * t + cross(turn.xyz, t);
}

/// Where the goal of r is now [m].
vec3 goalPlace(uint body, vec3 r)
{
    vec3 start = texelFetch(bodyStarts, int(2u * body)).xyz;
    return start + rotate(texelFetch(bodyStarts, int(2u * body + 1u)), r) + goalMove(body, r);
}
