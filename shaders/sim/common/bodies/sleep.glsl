// Islands that sleep. An assembly (what joints connect; a loose particle is one) counts the steps for which it was
// calm. Its count is at most one more than the least count of what it touches, so it also tells over how many contacts
// the nearest thing that moves is away. At calmSteps the assembly sleeps: it stays where it is, keeps its impulses, and
// nothing moves it. An island is what touches; its name is the lowest index of its assemblies. It wakes as a whole.
// Freezing (paper, section 3.1) is the same for each assembly by itself: it counts the steps for which all its
// particles have stayed near where they were, and wakes alone when a neighbour has moved away.
// SLEEP: of a world where things may sleep or freeze.

#ifdef SLEEP
uniform usamplerBuffer assemblyCalm;
#endif

/// For how long an assembly has been calm. BUFFER(Calm, AssemblyCalm, ...) stores it.
struct Calm {
    uint steps;
    uint island;     // the name of its island
};

#ifdef SLEEP
Calm fetchCalm(uint assembly)
{
    uvec2 t = texelFetch(assemblyCalm, int(assembly)).xy;
    return Calm(t.x, t.y);
}
#endif

bool sleeps(Calm calm)
{
    return calm.steps >= sim.calmSteps;
}

bool isAsleep(uint assembly)
{
#ifdef SLEEP
    return sleeps(fetchCalm(assembly));
#else
    return false;
#endif
}
