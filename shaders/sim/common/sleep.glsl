// Islands that sleep. An assembly (what joints connect; a loose particle is one) counts the steps for which it was
// calm, but one more at most than the least of what it touches: so the count is also how many contacts the next thing
// that moves is away. At calmSteps it sleeps: it keeps its place and its impulses, and nothing moves it. What sleeps
// has the name of its island, the least assembly that the island consists of, and wakes with all of it.
// Freezing (paper, section 3.1) is the same for each assembly by itself: it counts the steps for which all its particles
// have stayed near where they were, and wakes alone when a neighbour has left such a place. SLEEP: of a world where things
// may do either.

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
