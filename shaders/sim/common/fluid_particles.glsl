// What `positions` and `velocities` hold of a fluid particle (sim/common/grid/fluid_living.glsl). Fluid particles come
// after all solid ones.
#include "sim/common/grid/fluid_living.glsl"

bool isFluid(uint particle)
{
    return particle >= sim.particleCount;
}

/// The diameter of a solid particle for fluids [m].
float solidDiameter(uint particle)
{
    return sim.diameter;
}

struct FluidPosition {
    vec3 position;   // [m]
    bool inactive;   // it waits in the pool of its emitter, or a drain has taken it: it is nowhere
};

FluidPosition fluidPosition(vec4 t)
{
    return FluidPosition(t.xyz, isInactive(t));
}

/// Changes the position and keeps whether it is inactive.
vec4 withPosition(vec4 t, vec3 position)
{
    return vec4(position, t.w);
}

struct FluidVelocity {
    vec3 velocity;   // [m/s]
    float timeHeld;  // how long only gravity changes it, after leaving a nozzle [s]; of viscous fluid nothing
};

FluidVelocity fluidVelocity(vec4 t)
{
    return FluidVelocity(t.xyz, timeHeld(t));
}

vec4 pack(FluidVelocity v)
{
    return vec4(v.velocity, v.timeHeld);
}
