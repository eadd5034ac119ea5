// Emitters and the pools of their particles. A pool is a list of its particles: first the inactive ones, then those in
// the scene, the oldest first. poolOrder holds the lists of all pools twice: a step reads one half and writes the
// other, the next step the other way round. Each pool starts a new chunk (SCAN_CHUNK) of the list; NONE fills its last
// one.
#include "sim/common/fluid_particles.glsl"

// A particle that has just left a nozzle keeps its velocity, except for gravity, until this many layers have followed
// it. With 0, jets that slow down burst; with 2, jets into fluid at rest do.
#define HELD_LAYERS 1.0

READ_BUFFER(Emitter, Emitters, emitters);
uniform usamplerBuffer emitterStates;    // two texels an emitter
uniform usamplerBuffer poolSums;

EmitterState fetchEmitterState(uint k)
{
    uvec4 a = texelFetch(emitterStates, int(2u * k)), b = texelFetch(emitterStates, int(2u * k + 1u));
    return EmitterState(a.x, a.y, a.z, uintBitsToFloat(a.w), b.x, 0u, 0u, 0u);
}

/// Fluid nearer than this blocks a particle that leaves the nozzle [m].
float clearanceOf(Emitter e)
{
    return e.velocity.w;
}

/// How many particles are inactive in all chunks before this one.
uint inactiveBefore(uint chunk)
{
    return texelFetch(poolSums, int(chunk)).x;
}

/// The number of complete steps, including this one: emitters and drains end a step.
uint stepsDone(uint substep)
{
    return substep / sim.substeps;
}

/// Start of the half of poolOrder that a step reads.
uint orderBefore(uint steps)
{
    return (steps & 1u) * sim.poolCapacity;
}

/// Start of the half of poolOrder that a step writes.
uint orderAfter(uint steps)
{
    return sim.poolCapacity - orderBefore(steps);
}

// Entries of fluidTotals.
#define PARTICLES_CAME 0
#define PARTICLES_LEFT 1

/// Takes a fluid particle out of the scene. A macro, because the blocks are those of the kernel.
#define DEACTIVATE(particle) \
    positions[particle].w = INACTIVE; \
    velocities[particle] = vec4(0); \
    atomicAdd(totals[PARTICLES_LEFT], 1u)
