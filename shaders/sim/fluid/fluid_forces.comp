// One thread a slot: adds what force fields and the air do to a fluid particle's velocity in the substep; gravity is
// part of its prediction. The air drags at drops and surfaces, not at particles inside.
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/common/force_fields.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, SlotPositions, newSlotPositions);

/// The part of a particle that the air reaches, by the density around it.
float exposure(uint k)
{
    return 1.0 - smoothstep(ALONE_DENSITY, SURFACE_DENSITY, fetchSlotCover(k).density);
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
    if (!isFluid(i)) return;
    FluidVelocity own = fluidVelocity(velocities[i]);
    if (own.timeHeld > 0.0) return;
    vec3 x = texelFetch(positions, int(i)).xyz;
    FieldSum fields = fieldsAt(x);
    vec3 wind = airVelocity(x) + fields.blown - own.velocity;
    // A drop of one particle is a sphere of the particle's volume.
    float drag = sim.dropDrag * sim.wind.w * fetchMass(i).inverseMass * exposure(k);
    vec3 gained = sim.substepTime * (fields.acceleration + dragAcceleration(wind, vec3(drag)));
    velocities[i] = pack(FluidVelocity(own.velocity + gained, 0.0));
    newSlotPositions[k].xyz += sim.substepTime * gained;
}
