// One thread a body: what fluid lacks to hold it up, or to leave it free, where it lies on colliders and no fluid gets
// between. What is lighter than water would stay on the floor of a tank.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/body_wets.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(float, BodySeals, newBodySeals);

/// The sum of slopes over the fluid before a face, over its area and the number of fluid particles in a volume: what
/// pressure gives over the slope is the depth times a fluid particle's weight over this, times h^2.
const float FACE = 0.36;

/// Sums over a body's particles, and how far it reaches upwards [m].
struct Sums {
    vec3 place, impulse, seal;
    float slopes, pressure, mass, lowest, highest;
};

void add(inout Sums sums, uint rank, vec3 up)
{
    ParticleWet wet = fetchParticleWet(rank);
    vec3 centre = fetchSlotPosition(fetchParticleSlot(fetchRankedParticle(rank))).position;
    float height = dot(centre, up), reach = 0.5 * sim.diameter;
    // Faces are half a diameter outside.
    sums.place += wet.slopes * centre - reach * wet.slope;
    sums.impulse += wet.impulse, sums.seal += wet.seal;
    sums.slopes += wet.slopes, sums.pressure += wet.pressure, sums.mass += wet.mass;
    sums.lowest = min(sums.lowest, height - reach), sums.highest = max(sums.highest, height + reach);
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.bodyCount) return;
    Mover mover = fetchMover(m);
    float gravity = length(sim.gravity.xyz), unit = gravity * sim.substepTime * sim.substepTime;
    vec3 up = -sim.gravity.xyz / max(gravity, 1e-20);
    Sums sums = Sums(vec3(0), vec3(0), vec3(0), 0.0, 0.0, 0.0, 1e30, -1e30);
    for (uint rank = mover.firstRank; rank < mover.firstRank + mover.rankCount; ++rank) add(sums, rank, up);
    float inverse = 1.0 / max(sums.slopes, 1e-20), mass = inverse * sums.mass;
    float depth = -inverse * sums.pressure * FACE / max(mass * unit, 1e-20);
    float level = inverse * dot(sums.place, up) + depth;
    float below = clamp((level - sums.lowest) / max(sums.highest - sums.lowest, 1e-20), 0.0, 1.0);
    float cells = float(mover.rankCount) * pow(sim.diameter / sim.fluidSpacing, 3.0);
    vec3 lacking = below * cells * mass * unit * up - sums.impulse;
    newBodySeals[m] = max(dot(lacking, sums.seal), 0.0) / max(dot(sums.seal, sums.seal), 1e-20);
}
