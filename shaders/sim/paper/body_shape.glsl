// Positions of a body's particles for shape matching: for its mass centre and the matrix A of eq. 9.
#include "sim/common/bodies/links.glsl"
#include "sim/paper/body_starts.glsl"

uniform samplerBuffer positions;
uniform samplerBuffer moved;
uniform samplerBuffer linkPulls;

struct LinkPosition {
    vec3 move;           // from where the body had the particle at the start of the substep [m]
    vec3 arm;            // from the body's centre then [m]
};

/// @param isShared whether other bodies own the particle, too. Then it starts at the mean of their goals, and is moved
/// further away from this body's goal by the pull that draws the body there (joint_goals).
LinkPosition linkPosition(uint l, LinkValues link, bool isShared)
{
    vec3 move = texelFetch(moved, int(link.particle)).xyz;
    BodyStart start = fetchBodyStart(link.body);
    vec3 arm = texelFetch(positions, int(link.particle)).xyz - start.centre + move;
    if (isShared) {
        arm += texelFetch(linkPulls, int(l)).xyz;
        move = arm - rotate(start.rotation, link.r);
    }
    return LinkPosition(move, arm);
}
