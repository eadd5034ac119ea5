// Emitters and the pools of their particles. A pool is a list of its particles: those that are parked first, then those
// that are there, the oldest first. poolOrder has two halves, one a step in turn; every pool begins a chunk of it.

#define NO_PARTICLE 0xffffffffu

// What has just left a nozzle keeps its way until so many layers have followed it. With none jets that slow down burst,
// with two what is pressed into fluid at rest does.
#define HELD_LAYERS 1.0

READ_BUFFER(GpuEmitter, Emitters, emitters);

/// Steps that are complete now: emitters and drains end a step.
uint stepsDone(uint substep)
{
    return substep / sim.substeps;
}

/// The half of poolOrder that a step reads; it writes the other.
uint orderBefore(uint steps)
{
    return (steps & 1u) * sim.poolCapacity;
}

uint orderAfter(uint steps)
{
    return sim.poolCapacity - orderBefore(steps);
}
