// Where a link's particle is, from the body's centre, for the matrix A of eq. 9.
#include "shared/quaternion.glsl"
#include "shared/links.glsl"

uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
uniform samplerBuffer linkOffsets;
#ifdef FROM_POSITIONS
uniform samplerBuffer positions;
#else
uniform samplerBuffer linkGaps;
#endif

/// A particle's move [m] with what the joint's impulse adds to it in this body.
vec3 linkMove(uint l, bool isShared, vec3 move, float factor)
{
    return isShared ? move + factor * texelFetch(linkOffsets, int(l)).xyz : move;
}

/// From the body's centre before the substep to the particle after `move` [m]. The body stood rigid then, but for a
/// joint's gap; its shape is exact where a difference of positions would bring their rounding. FROM_POSITIONS: for a
/// solver that moves particles off their goals (stabilization, freezing).
vec3 linkArm(LinkValues link, uint l, bool isShared, vec3 move)
{
#ifdef FROM_POSITIONS
    return texelFetch(positions, int(link.particle)).xyz - texelFetch(bodyStarts, int(2u * link.body)).xyz + move;
#else
    vec3 arm = rotate(texelFetch(bodyStarts, int(2u * link.body + 1u)), link.r) + move;
    return isShared ? arm + texelFetch(linkGaps, int(l)).xyz : arm;
#endif
}
