// Islands that sleep. An assembly (what joints connect; a loose particle is one) counts the steps for which it was
// calm, but one more at most than the least of what it touches: so the count is also how many contacts the next thing
// that moves is away. At CALM_STEPS it sleeps: it keeps its place and its impulses, and nothing moves it. What sleeps
// has the name of its island, the least assembly that the island consists of, and wakes with all of it. SLEEP: of a
// world where things may.

#ifdef SLEEP
uniform usamplerBuffer assemblyCalm;     // calm steps, name of the island
#endif

bool isAsleep(uint assembly)
{
#ifdef SLEEP
    return texelFetch(assemblyCalm, int(assembly)).x >= CALM_STEPS;
#else
    return false;
#endif
}
