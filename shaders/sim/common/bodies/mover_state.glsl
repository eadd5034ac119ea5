// Points of movers as they are between steps.
#include "sim/common/bodies/fields.glsl"
#include "sim/common/bodies/mover_poses.glsl"

uniform samplerBuffer moverVelocities;

struct PointState {
    vec3 position;   // [m]
    vec3 velocity;   // [m/s]
};

/// State of the point of a mover at r in its axes.
PointState pointState(uint mover, vec3 r)
{
    Field velocity = fetchField(moverVelocities, mover);
    vec3 arm = rotate(fetchRotation(mover), r);
    return PointState(fetchCentre(mover) + arm, velocity.t + velocity.f * r);
}
