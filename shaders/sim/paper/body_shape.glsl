// Where shape matching sees the particles of a body, for its mass centre and the matrix A of eq. 9.
#include "sim/common/links.glsl"
#include "math/quaternion.glsl"

uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
uniform samplerBuffer positions;
uniform samplerBuffer moved;
uniform samplerBuffer linkPulls;

struct LinkPlace {
    vec3 move;           // from where the body had the particle at the start of the substep [m]
    vec3 arm;            // from the body's centre then [m]
};

/// @param isShared whether other bodies own the particle too. It starts at the mean of their goals then, and stands
/// further from this body's by what draws the body there (joint_goals).
LinkPlace linkPlace(uint l, LinkValues link, bool isShared)
{
    vec3 move = texelFetch(moved, int(link.particle)).xyz;
    vec3 centre = texelFetch(bodyStarts, int(2u * link.body)).xyz;
    vec3 arm = texelFetch(positions, int(link.particle)).xyz - centre + move;
    if (isShared) {
        arm += texelFetch(linkPulls, int(l)).xyz;
        move = arm - rotate(texelFetch(bodyStarts, int(2u * link.body + 1u)), link.r);
    }
    return LinkPlace(move, arm);
}
