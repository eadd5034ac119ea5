// Where a link's particle is, from the body's centre, for the matrix A of eq. 9.
#include "shared/links.glsl"

uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
uniform samplerBuffer positions;

/// From the body's centre before the substep to the particle after `move` [m].
vec3 linkArm(LinkValues link, vec3 move)
{
    return texelFetch(positions, int(link.particle)).xyz - texelFetch(bodyStarts, int(2u * link.body)).xyz + move;
}
