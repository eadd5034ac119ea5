// A spring and a damper between where something is and where its clip has it, as they are at the end of the substep.
#include "math/quaternion.glsl"
#include "math/symmetric.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "shared/drive_types.h"
#include "shared/animation_types.h"

READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer driveLevels;

/// The turn of a quaternion, at most half a one [rad].
vec3 turnOfQuaternion(vec4 q)
{
    if (q.w < 0.0) q = -q;
    float s = length(q.xyz);
    return (s > 1e-7 ? 2.0 * atan(s, q.w) / s : 2.0) * q.xyz;
}

/// How fast a difference changes, times the substep: BDF2's, as of the velocities of what it is between.
/// @param change in this substep. @param last in the one before.
vec3 rateOf(vec3 change, vec3 last, bool second)
{
    return second ? 1.5 * change - 0.5 * last : change;
}

/// What a spring adds to the inertia that it moves, for its force to be that at the substep's end.
/// @param damping over the stiffness' inertia [1/s].
float implicitPart(float stiffness, float damping, bool second)
{
    return stiffness + (second ? 1.5 : 1.0) * damping / sim.substepTime;
}

/// The part of a force that is given where it has a greatest size.
float boundedPart(float force, float greatest)
{
    return min(1.0, greatest / max(force, 1e-20));
}

/// Whether a block has changed so much that it should be factored anew.
float isStale(vec3 before, vec3 now)
{
    const float MOST_CHANGE = 0.1;
    vec3 change = abs(now - before);
    float size = before.x + before.y + before.z;
    return change.x + change.y + change.z > MOST_CHANGE * size ? 1.0 : 0.0;
}

vec4 turnedNow(uint body)
{
    return quaternionProduct(fetchRotationDelta(body), fetchRotation(body));
}

mat3 inertiaNow(vec4 inertia, vec4 beside, vec4 rotation)
{
    mat3 axes = matrixFromQuaternion(rotation);
    return axes * symmetricMatrix(inertia.xyz, beside.xyz) * transpose(axes);
}
