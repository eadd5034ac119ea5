// Sleep. An assembly (bodies that joints connect; a loose particle is one) counts its calm steps. Its count is at most
// one more than the least count of those that it touches, so it also tells over how many contacts the nearest moving
// one is away. At calmSteps the assembly sleeps: sleep_state tells its movers, which then stay where they are, keep
// their impulses, and answer to nothing. An island is a set of assemblies that touch; its name is the lowest of their
// indices. It wakes as a whole.
// Freezing (paper, section 3.1) does the same for each assembly by itself: it counts the steps in which all its
// particles have stayed near where they were, and wakes alone when a neighbour has moved away.
#include "sim/common/bodies/mover_info.glsl"

uniform usamplerBuffer assemblyCalm;

/// Calm steps of an assembly. BUFFER(Calm, AssemblyCalm, ...) stores it.
struct Calm {
    uint steps;
    uint island;     // the name of its island
};

Calm fetchCalm(uint assembly)
{
    uvec2 t = texelFetch(assemblyCalm, int(assembly)).xy;
    return Calm(t.x, t.y);
}

bool sleeps(Calm calm)
{
    return calm.steps >= sim.calmSteps;
}

/// Whether a mover falls asleep and wakes with its assembly: all except held and animated ones.
bool mayRest(uint m)
{
    uint state = texelFetch(moverStates, int(m)).x;
    return state == MOVER_DYNAMIC || state == MOVER_ASLEEP;
}
