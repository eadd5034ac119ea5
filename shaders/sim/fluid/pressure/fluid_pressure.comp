// One thread a slot: moves its fluid particle by the pressures around it (Macklin and Mueller 2013, eq. 12, with
// masses: a pair exchanges the impulse (lambda_i + lambda_j) grad W, so momentum is kept), ends its substep, and
// predicts the next. RELAX: moves it without changing its velocity, and a little further along its moves of earlier
// passes. SETTLE: by its weight, too. FREE, WALLED, COVERED: one thread a slot of a list.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/nan_report.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/fluid/walls/slot_lists.glsl"
#ifdef WALLS
#include "sim/fluid/walls/fluid_colliders.glsl"
#endif
#include "sim/fluid/pressure/pressure_impulses.glsl"

layout(local_size_x = GROUP_SIZE) in;
FLOAT_TEXELS(positions)
FLOAT_TEXELS(newSlotPositions)
#if defined(RELAX) || defined(SETTLE)
READ_BUFFER(vec4, Velocities, velocities);
#define LAST_VELOCITY(i) velocities[i]
BUFFER(uint, FluidLargestPush, fluidLargestPush);
#endif
#if defined(RELAX)
BUFFER(vec4, FluidPasts, fluidPasts);
#elif defined(SETTLE)
FLOAT_TEXELS(newSlotMoves)
#else
FLOAT_TEXELS(velocities)
#define LAST_VELOCITY(i) imageLoad(velocities, int(i))
FLOAT_TEXELS(newSlotMoves)
#ifdef SOLIDS
FLOAT_TEXELS(newSlotSolidImpulses)
#endif
BUFFER(Counters, CountersBlock, counters);
#endif

void main()
{
    if (gl_GlobalInvocationID.x >= listedSlots()) return;
    uint k = listedSlot(gl_GlobalInvocationID.x), i = fetchSlotParticle(k);
    if (!isFluid(i)) return;
    SlotPressure own = fetchSlotPressure(k);
    FluidImpulses others = fluidImpulses(k, fetchCounts(k).fluids, own);
    vec3 impulse = others.pressure + others.tension;
    SlotCover cover = fetchSlotCover(k);
#ifdef WALLS
#ifdef SOLIDS
    SlotSolidCover solids = fetchSlotSolids(k);
#else
    SlotSolidCover solids = SlotSolidCover(vec3(0), 0.0);
#endif
    PressureImpulse pressed = pressedBy(own, cover.fraction, fetchSlotWalls(k), solids, others.pressure);
    impulse = pressed.all + others.tension;
#endif
    FluidVelocity last = fluidVelocity(LAST_VELOCITY(i));
    float inverseMass = fetchMass(i).inverseMass, mass = 1.0 / max(inverseMass, 1e-20);
    vec3 push = inverseMass * impulse;
    push *= min(1.0, 0.25 * sim.fluidReach / max(length(push), 1e-20));
#ifdef SETTLE
    push += predictedPosition(vec3(0), vec3(0)) + FLUID_MOMENTUM * imageLoad(newSlotMoves, int(k)).xyz;
#endif
    if (last.timeHeld > 0.0) push = vec3(0);
    vec4 place = imageLoad(positions, int(i));
    vec3 before = place.xyz, x = own.position + push;
#ifdef WALLS
    x = outside(k, x);
#endif
    imageStore(positions, int(i), withPosition(place, x));
#if defined(SETTLE)
    imageStore(newSlotPositions, int(k), pack(SlotPosition(x, mass)));
    imageStore(newSlotMoves, int(k), pack(SlotMove(x - before, false)));
    atomicMax(fluidLargestPush[0], floatBitsToUint(length(x - before)));
#elif defined(RELAX)
    fluidPasts[i].xyz = x;
    vec3 move = x - before;
    // It stays among the neighbours and walls that are listed for it, and does not go between solids that would squeeze
    // it out in the first step.
    move *= min(1.0, 0.1 * sim.fluidSpacing / max(length(move), 1e-20));
    vec3 next = fetchCounts(k).solids > 0u ? x : x + FLUID_MOMENTUM * move;
    imageStore(newSlotPositions, int(k), pack(SlotPosition(next, mass)));
    atomicMax(fluidLargestPush[0], floatBitsToUint(length(push)));
#else
    vec3 v = (x - before) * (sim.damping / sim.substepTime);
    float speed = length(v);
    if (isnan(speed) || isinf(speed)) { REPORT_NAN(i); }
    v *= min(1.0, mostSpeed(cover, length(last.velocity), speed) / max(speed, 1e-20));
    imageStore(velocities, int(i), pack(FluidVelocity(v, max(last.timeHeld - sim.substepTime, 0.0))));
    vec3 next = predictedPosition(x, v);
    imageStore(newSlotPositions, int(k), pack(SlotPosition(next, mass)));
    imageStore(newSlotMoves, int(k), pack(SlotMove(next - own.position, false)));
#ifdef SOLIDS
    vec4 toSolids = vec4(solids.inverseWeight * pressed.bySolids, pressed.push * cover.gain);
    imageStore(newSlotSolidImpulses, int(k), toSolids);
#endif
#endif
}
