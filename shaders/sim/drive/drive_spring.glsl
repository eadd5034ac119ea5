// A spring and a damper between where something is and where its clip has it, as they are at the end of the substep.
#include "math/symmetric.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/drive/drive_states.glsl"
#include "sim/drive/turns.glsl"
#include "shared/animation_types.h"

READ_BUFFER(AnimatedBody, AnimatedBodies, animatedBodies);
uniform samplerBuffer driveLevels;
uniform samplerBuffer driveInertias;

/// A substep of what a spring moves.
struct SpringTime {
    bool second;           // order of its time integration
    float squaredTime;     // by which forces count [s2]
};

SpringTime springTime(uint body)
{
    Assembly assembly = fetchAssembly(fetchMover(body).assembly);
    return SpringTime(assembly.order == 2u, accelerationFactor(assembly) * sim.substepTime * sim.substepTime);
}

/// How fast a difference changes: BDF2's, as of the velocities of what it is between.
/// @param change in this substep. @param last in the one before.
vec3 rateOf(vec3 change, vec3 last, SpringTime time)
{
    return (time.second ? 1.5 * change - 0.5 * last : change) / sim.substepTime;
}

/// What a spring adds to the inertia that it moves, over what it is a multiple of, for its force to be that at the
/// substep's end.
float implicitPart(float stiffness, float damping, SpringTime time)
{
    return time.squaredTime * (stiffness + (time.second ? 1.5 : 1.0) * damping / sim.substepTime);
}

/// The part of a force that is given where it has a greatest size.
float boundedPart(vec3 force, float greatest)
{
    return min(1.0, greatest / max(length(force), 1e-20));
}

/// 1 where a block has changed so much that it should be factored anew.
float isStale(vec3 before, vec3 now)
{
    const float MOST_CHANGE = 0.1;
    vec3 change = abs(now - before);
    return change.x + change.y + change.z > MOST_CHANGE * (before.x + before.y + before.z) ? 1.0 : 0.0;
}

vec4 turnedNow(uint body)
{
    return quaternionProduct(fetchRotationDelta(body), fetchRotation(body));
}

/// What an animated body's drive turns, or its pin [kg m2].
mat3 fetchInertia(uint body, uint pin)
{
    int first = int(4u * body + 2u * pin);
    return symmetricMatrix(texelFetch(driveInertias, first).xyz, texelFetch(driveInertias, first + 1).xyz);
}
