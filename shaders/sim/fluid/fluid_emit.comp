// One thread a particle that is to leave an emitter in this step: its layer left the nozzle at its own moment of the
// step, and the particle goes where it has come to since. Where something else stands it stays in the pool.
#include "sim/common/kernel.glsl"
#include "sim/common/fluid_grid.glsl"
#include "sim/common/grid.glsl"
#include "sim/fluid/emitters.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer nozzlePoints;
uniform usamplerBuffer emitterStates;    // two texels each
uniform usamplerBuffer poolOrder;
uniform usamplerBuffer cellStarts;
uniform usamplerBuffer slotParticles;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, Positions, positions);
BUFFER(vec4, Velocities, velocities);
BUFFER(uint, FluidTotals, totals);       // came, left

/// Whether nothing is in the way at x. Who is there is known from the neighbours of this step, where they are now from
/// positions: what this step emits was in no cell.
bool hasRoom(vec3 x, float room)
{
    float solidRoom = 0.45 * (sim.diameter + sim.fluidSpacing);
    uint slots = texelFetch(cellStarts, int(gridMask() + 1u)).x;
    ivec3 cell = cellOf(x);
    bool free = true;
    for (int range = 0; range < AROUND_RANGES; ++range) {
        uvec2 cells = aroundCells(cell, range);
        uint end = texelFetch(cellStarts, int(cells.y)).x;
        for (uint place = texelFetch(cellStarts, int(cells.x)).x; place < end; ++place) {
            // The first cells are listed once more behind the last.
            uint i = texelFetch(slotParticles, int(place < slots ? place : place - slots)).x;
            vec4 other = positions[i];
            vec3 r = x - other.xyz;
            float near = i < sim.particleCount ? solidRoom : room;
            free = free && (isInactive(other) || dot(r, r) >= near * near);
        }
    }
    return free;
}

void main()
{
    uint candidate = gl_GlobalInvocationID.x, k = 0u, last = uint(emitters.length()) - 1u;
    uvec4 state = texelFetch(emitterStates, 0), timing = texelFetch(emitterStates, 1);
    // state.x particles from timing.x on are those of an emitter.
    while (candidate >= timing.x + state.x && k < last) {
        ++k;
        state = texelFetch(emitterStates, int(2u * k));
        timing = texelFetch(emitterStates, int(2u * k + 1u));
    }
    uint q = candidate - timing.x;
    if (q >= state.x) return;
    GpuEmitter e = emitters[k];
    uint laterLayers = state.x / e.pointCount - 1u - q / e.pointCount;
    float t = uintBitsToFloat(state.w) + float(laterLayers) * e.interval;
    // As the solver's steps would have brought it here.
    vec3 fall = sim.gravity.xyz * t;
    vec3 nozzle = texelFetch(nozzlePoints, int(e.firstPoint + q % e.pointCount)).xyz;
    vec3 x = nozzle + t * e.velocity.xyz + 0.5 * (t + sim.substepTime) * fall;
    if (!hasRoom(x, e.velocity.w)) return;
    uint place = e.poolStart + e.poolCount - state.x + q;
    uint i = texelFetch(poolOrder, int(orderAfter(stepsDone(counters[0].substep)) + place)).x;
    positions[i] = vec4(x, 0);
    velocities[i] = vec4(e.velocity.xyz + fall, max(HELD_LAYERS * e.interval - t, 0.0));
    atomicAdd(totals[0], 1u);
}
