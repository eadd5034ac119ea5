// Implicit springs: their force is that at the end of the substep, as far as one step of Newton's method knows it.
#include "math/symmetric.glsl"
#include "sim/common/bodies/assemblies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/drive/turns.glsl"

/// Time step of a spring.
struct SpringTime {
    bool second;           // order of its time integration
    float squaredTime;     // factor of forces [s2]
};

SpringTime springTime(uint body)
{
    Assembly assembly = fetchAssembly(fetchMover(body).assembly);
    return SpringTime(assembly.order == 2u, accelerationFactor(assembly) * sim.substepTime * sim.substepTime);
}

/// The rate of change of a difference: by BDF2 if the velocities of the two use it.
/// @param change in this substep. @param last in the one before.
vec3 rateOf(vec3 change, vec3 last, SpringTime time)
{
    return (time.second ? 1.5 * change - 0.5 * last : change) / sim.substepTime;
}

/// What a spring adds to the resistance to moves, as a multiple of what it moves, so that its force is that at the
/// substep's end.
float implicitPart(float stiffness, float damping, SpringTime time)
{
    return time.squaredTime * (stiffness + (time.second ? 1.5 : 1.0) * damping / sim.substepTime);
}

/// The part of a force that a limit on its size leaves.
float boundedPart(vec3 force, float greatest)
{
    return min(1.0, greatest / max(length(force), 1e-20));
}

/// 1 if a block has changed so much that it should be factored anew.
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
