// The mover that a thread works for, in kernels that are compiled for each kind: FREE, bodies without joints; JOINTED,
// bodies with joints; LOOSE particles. So no thread does the work of two kinds. Bodies that never respond are in none.

#ifdef LOOSE
#define THREAD_COUNT (sim.moverCount - sim.bodyCount)

uint moverOfThread(uint thread)
{
    return sim.bodyCount + thread;
}
#else
uniform usamplerBuffer bodyOrder;        // free ones, then jointed ones

#define BODIES
#ifdef JOINTED
#define THREAD_COUNT sim.jointedBodyCount
#define FIRST_THREAD sim.freeBodyCount
#else
#define THREAD_COUNT sim.freeBodyCount
#define FIRST_THREAD 0u
#endif

uint moverOfThread(uint thread)
{
    return texelFetch(bodyOrder, int(FIRST_THREAD + thread)).x;
}
#endif
