// Points of movers as they are between steps.
#include "sim/common/fields.glsl"
#include "math/quaternion.glsl"

uniform samplerBuffer moverCentres;
uniform samplerBuffer moverRotations;
uniform samplerBuffer moverVelocities;

struct PointState {
    vec3 position;   // [m]
    vec3 velocity;   // [m/s]
};

PointState pointState(uint mover, vec3 r)
{
    Field velocity = fetchField(moverVelocities, mover);
    vec3 arm = rotate(texelFetch(moverRotations, int(mover)), r);
    return PointState(texelFetch(moverCentres, int(mover)).xyz + arm, velocity.t + velocity.f * r);
}
