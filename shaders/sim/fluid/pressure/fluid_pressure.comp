// One thread a slot: moves its fluid particle by the pressures around it (Macklin and Mueller 2013, eq. 12, with
// masses: a pair exchanges the impulse (lambda_i + lambda_j) grad W, so momentum is kept), ends its substep, and
// predicts the next. RELAX: moves it without changing its velocity, and a little further along its moves of earlier
// passes, so that what the walls press out of a column rises through it in few passes.
#include "sim/common/kernel.glsl"
#include "sim/common/nan_report.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/fluid_colliders.glsl"
#include "sim/fluid/pressure/pressure_impulses.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, SlotPositions, newSlotPositions);
BUFFER(vec4, FluidPasts, fluidPasts);
#ifdef RELAX
BUFFER(uint, FluidLargestPush, fluidLargestPush);
#else
BUFFER(vec4, SlotLastPositions, newSlotLastPositions);
BUFFER(vec4, SlotSolidImpulses, newSlotSolidImpulses);
BUFFER(Counters, CountersBlock, counters);
#endif

/// Pushes x out of the colliders, at least a quarter of the rest distance away from them.
vec3 outside(uint k, vec3 x)
{
    for (NearColliders near = nearColliders(k); nextCollider(near);) {
        ColliderSurface wall = colliderSurface(near.index, x);
        x += max(0.25 * sim.fluidSpacing - wall.distance, 0.0) * wall.normal;
    }
    return x;
}

/// The highest speed that a particle may reach if it had the speed `before` and would have `now`. Being pushed out
/// between solids, or a solid and a wall, in one substep would make it as fast as that takes. It keeps the largest
/// speed that it or they had, and gets a little more.
float mostSpeed(uint k, vec3 x, float before, float now)
{
    float gain = MOST_SQUEEZE * sim.substepTime, fastest = before;
    if (now <= before + gain) return sim.maxSpeed;
    uint count = fetchCounts(k).solids;
    bool among = false;
    for (uint n = 0u; n < count; ++n) {
        uint solid = fetchSolidNeighbour(k, n);
        if (distance(x, fetchPressurePosition(solid)) >= sim.fluidListReach) continue;
        among = true;
        fastest = max(fastest, length(fetchSlotVelocity(solid).velocity));
    }
    return among ? min(fastest + gain, sim.maxSpeed) : sim.maxSpeed;
}

void main()
{
    uint k = gl_GlobalInvocationID.x;
    if (k >= slotCount()) return;
    uint i = fetchSlotParticle(k);
#ifndef RELAX
    newSlotSolidImpulses[k] = vec4(0);   // a solid's own, which fills up its list of neighbours
#endif
    if (!isFluid(i)) return;
    SlotPressure own = fetchSlotPressure(k);
    FluidImpulses others = fluidImpulses(k, fetchCounts(k).fluids, own);
    SlotSolidCover solids = fetchSlotSolids(k);
    PressureImpulse pressed = pressedBy(own, fetchSlotCovered(k), fetchSlotWalls(k), solids, others.pressure);
    vec3 push = fetchMass(i).inverseMass * (pressed.all + others.tension);
    FluidVelocity last = fluidVelocity(velocities[i]);
    push *= last.timeHeld > 0.0 ? 0.0 : min(1.0, 0.25 * sim.fluidReach / max(length(push), 1e-20));
    vec3 before = positions[i].xyz, x = outside(k, own.position + push);
#ifdef RELAX
    positions[i].xyz = x;
    fluidPasts[i].xyz = x;
    vec3 move = x - before;
    // It stays among the neighbours and walls that are listed for it, and does not go between solids that would squeeze
    // it out in the first step.
    move *= min(1.0, 0.1 * sim.fluidSpacing / max(length(move), 1e-20));
    newSlotPositions[k].xyz = fetchCounts(k).solids > 0u ? x : x + FLUID_MOMENTUM * move;
    atomicMax(fluidLargestPush[0], floatBitsToUint(length(push)));
#else
    vec3 v = (x - before) * (sim.damping / sim.substepTime);
    float speed = length(v);
    if (isnan(speed) || isinf(speed)) {
        REPORT_NAN(i);
    }
    float most = mostSpeed(k, own.position, length(last.velocity), speed);
    v *= min(1.0, most / max(speed, 1e-20));
    velocities[i] = pack(FluidVelocity(v, max(last.timeHeld - sim.substepTime, 0.0)));
    positions[i].xyz = x;
    newSlotPositions[k].xyz = predictedPosition(x, v);
    newSlotLastPositions[k] = pack(SlotLast(own.position, false));
    fluidPasts[i].xyz = own.position;
    float answer = pressed.push * texelFetch(slotGains, int(k)).x;
    newSlotSolidImpulses[k] = vec4(solids.inverseWeight * pressed.bySolids, answer);
#endif
}
