// One thread a slot: how compressed its fluid particle is and the multiplier of its density constraint (Macklin and
// Mueller 2013, eqs. 8-11, with masses). Compression grows by the divergence of the moves since the last substep, with
// the same gradients by which fluid_pressure pushes: so what is pressed gives back the work that went in. (The density
// that kernels sum up would change where fluid only shears.) RELAX: as kernels sum it up.
// SETTLE: the way to what they sum up is short.
// FREE, WALLED, COVERED: one thread a slot of a list.
#define UNIFORM_PARAMETERS
#include "sim/common/kernel.glsl"
#include "sim/common/particles.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "sim/fluid/slot_values.glsl"
#include "sim/fluid/pressure/slot_pressures.glsl"
#include "sim/fluid/fluid.glsl"
#include "sim/common/fluid_past.glsl"
#include "sim/fluid/walls/slot_lists.glsl"
#include "sim/fluid/pressure/compression.glsl"
#ifdef WALLS
#include "sim/fluid/walls/sides.glsl"
#endif

layout(local_size_x = GROUP_SIZE) in;
UINT_TEXELS(newSlotPressures)
FLOAT_TEXELS(newSlotCovers)
FLOAT_TEXELS(fluidPasts)

/// The part of the kernel's error that is mixed into what a particle carries.
float mixingOf(uint k)
{
#ifdef SETTLE
    return FLUID_START_MIXING;
#else
    mat3 slope = fetchSlotGradient(k).slope;
    float squares = dot(slope[0], slope[0]) + dot(slope[1], slope[1]) + dot(slope[2], slope[2]);
    float flow = sqrt(squares) / max(sim.evenSmoothing, 1e-6) - sim.quietSpeed / sim.fluidSpacing;   // [1/s]
    return min(FLUID_MIXING + FLUID_FLOW_MIXING * sim.substepTime * max(flow, 0.0), MOST_FLUID_MIXING);
#endif
}

void main()
{
    if (gl_GlobalInvocationID.x >= listedSlots()) return;
    uint k = listedSlot(gl_GlobalInvocationID.x), i = fetchSlotParticle(k);
    NeighbourCounts counts = fetchFluidCounts(k, i);
    vec3 x = fetchSlotPosition(k).position;
    SlotMove last = fetchSlotMove(k);
    Own own = Own(x, last.move, fetchSlotShape(k));
    Sums sums = sumsOver(k, counts.fluids, own);
    if (!isFluid(i)) {
        imageStore(newSlotPressures, int(2u * k), uvec4(floatBitsToUint(x), 0u));
        imageStore(newSlotPressures, int(2u * k + 1u), uvec4(0u));
        return;
    }
#ifdef WALLS
    Sides sides = sidesOf(k, counts.solids, own);
#else
    Sides sides = Sides(vec3(0), 0.0, 0.0, 0.0, 1.0, NO_SOLID);
#endif
    float density = sums.fraction + sides.fraction;
    float excess = clamp(density - 1.0, LEAST_FLUID_ERROR, MOST_FLUID_ERROR);
#ifdef RELAX
    float compression = excess, relaxation = FLUID_START_RELAXATION;
#else
    float carried = imageLoad(fluidPasts, int(i)).w + sums.nearer + sides.nearer;
    carried = clamp(carried, LEAST_FLUID_ERROR, MOST_FLUID_ERROR);
    // New particles count as far as there was no room for them.
    carried = max(carried, min(carried + sums.added, excess));
    float compression = mix(carried, excess, last.isNew || density < FLUID_LOOSE ? 1.0 : mixingOf(k));
    float relaxation = FLUID_RELAXATION;
#endif
#ifdef SETTLE
    x = predictedPosition(x, vec3(0));   // where the first substep expects what rests
#endif
    imageStore(fluidPasts, int(i), pack(FluidPast(x, compression)));
    imageStore(newSlotCovers, int(k), pack(SlotCover(sides.fraction, sides.gain, sides.fastest, density)));
    vec3 all = sums.gradient + sides.gradient;
    // Where the slopes of solids cancel, as between two of them, there is no way out: a harder push does not help.
    // All constraints around are solved at once, each as if alone: relaxed less, they would overshoot.
    float squares = dot(all, all) + sides.opposed + sums.squares;
    float lambda = -relaxation * max(compression, 0.0) / (squares + sim.fluidSoftness);
    SlotPressure pressure = SlotPressure(own.position, lambda / max(fetchMass(i).inverseMass, 1e-20) * own.even);
    imageStore(newSlotPressures, int(2u * k), firstHalf(pressure));
    imageStore(newSlotPressures, int(2u * k + 1u), secondHalf(pressure));
}
