// Goals of shape matching for the particles of a body.
#include "sim/common/bodies/links.glsl"
#include "sim/paper/body_starts.glsl"

uniform samplerBuffer moverMoves;        // of the centre since the substep began
uniform samplerBuffer moverRotationDeltas;

/// How far the goal of r has moved in the substep [m]. Computed from the rotation delta instead of two positions, which
/// keeps rounding errors as small as the move.
vec3 goalMove(uint body, vec3 r)
{
    vec3 arm = rotate(fetchBodyStart(body).rotation, r);
    vec4 delta = texelFetch(moverRotationDeltas, int(body));
    return movedByTurn(texelFetch(moverMoves, int(body)).xyz, delta, arm);
}

/// The current goal of r [m].
vec3 goalPosition(uint body, vec3 r)
{
    BodyStart start = fetchBodyStart(body);
    return start.centre + rotate(start.rotation, r) + goalMove(body, r);
}
