// One thread a particle that is to leave an emitter in this step. Its layer left the nozzle at its own moment of the
// step, and the particle starts where it has moved to since. If something else is there, it stays inactive. AGES: of a
// world that keeps ages.
#include "sim/common/kernel.glsl"
#include "sim/common/grid/fluid_grid.glsl"
#include "sim/common/grid/grid.glsl"
#include "sim/emitter/emitters.glsl"
#include "sim/common/fluid_past.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer nozzlePoints;
uniform usamplerBuffer poolOrder;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer slotParticles;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(vec4, FluidPasts, fluidPasts);
BUFFER(uint, FluidTotals, totals);
#ifdef AGES
BUFFER(float, ParticleAges, particleAges);   // [s]
#endif

/// Whether nothing is in the way at x. The cells, made at the start of the step, say which particles may be near;
/// `positions` has their current places. Particles of this step are in no cell. @param room  Fluid particles have to be
/// this far away [m].
bool hasRoom(vec3 x, float room)
{
    uint slots = texelFetch(cellStarts, int(gridMask() + 1u)).x;
    ivec3 cell = cellOf(x);
    bool free = true;
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = aroundCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint index = texelFetch(cellStarts, int(cells.x)).x; index < end; ++index) {
            // The first cells are listed again after the last.
            uint i = texelFetch(slotParticles, int(index < slots ? index : index - slots)).x;
            FluidPosition other = fluidPosition(positions[i]);
            vec3 r = x - other.position;
            float clearance = isFluid(i) ? room : 0.45 * (solidDiameter(i) + sim.fluidSpacing);
            free = free && (other.inactive || dot(r, r) >= clearance * clearance);
        }
    }
    return free;
}

void main()
{
    uint candidate = gl_GlobalInvocationID.x, k = 0u, last = uint(emitters.length()) - 1u;
    EmitterState state = fetchEmitterState(0u);
    while (candidate >= state.firstCandidate + state.taken && k < last) state = fetchEmitterState(++k);
    uint q = candidate - state.firstCandidate;
    if (q >= state.taken) return;
    Emitter e = emitters[k];
    uint laterLayers = state.taken / e.pointCount - 1u - q / e.pointCount;
    float t = state.age + float(laterLayers) * e.interval;   // since it left the nozzle
    // The fall as the solver's steps would have computed it.
    vec3 fall = sim.gravity.xyz * t;
    vec3 nozzle = texelFetch(nozzlePoints, int(e.firstPoint + q % e.pointCount)).xyz;
    vec3 x = nozzle + t * e.velocity.xyz + 0.5 * (t + sim.substepTime) * fall;
    if (!hasRoom(x, clearanceOf(e))) return;
    uint index = e.poolStart + e.poolCount - state.taken + q;
    uint i = texelFetch(poolOrder, int(orderAfter(stepsDone(counters[0].substep)) + index)).x;
    positions[i] = vec4(x, 0);
    fluidPasts[i] = pack(FluidPast(x, JUST_EMITTED));
    velocities[i] = pack(FluidVelocity(e.velocity.xyz + fall, max(HELD_LAYERS * e.interval - t, 0.0)));
#ifdef AGES
    particleAges[i] = t;
#endif
    atomicAdd(totals[PARTICLES_CAME], 1u);
}
