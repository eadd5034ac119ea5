// Damps Newton's method for trees of joints where light bodies carry heavy ones: these turn far for a small error,
// beyond the linear range, and further answers only turn them to and fro.
#include "sim/common/bodies/movers.glsl"
#include "math/spatial.glsl"
#include "sim/joint/joint_info.glsl"

/// The load that a body carries, as if it moved alone. @param carried the mass of it and of all that hangs on it.
/// @returns the part of that beyond a hundred times its own mass [kg].
float loadOn(uint k, mat3 carried)
{
    const float LIGHT = 100.0;
    return max(0.0, meanMass(carried) - LIGHT / fetchMover(fetchJoint(k).body).inverseMass);
}

/// Levenberg and Marquardt's damping (Nocedal and Wright 2006, 10.3): such a body resists its next turn by a part of
/// its load, which thus takes more of the error. As answers converge, turns and this damping vanish: it changes how a
/// solution is found, not the solution. @param turn the last one [rad]. @returns what to add to its inertia [kg m2].
float turnDamping(uint k, mat3 carried, float turn)
{
    const float PER_RADIAN = 5.0, MOST = 0.1;   // parts of the load
    vec3 arm = fetchJointPlace(k, 0u).arm;
    return min(MOST, PER_RADIAN * turn) * loadOn(k, carried) * dot(arm, arm);
}
