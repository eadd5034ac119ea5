// Tells the host that a particle's velocity is no longer a finite number. A macro, because `counters` is a block of the
// kernel.
#define REPORT_NAN(particle) \
    atomicOr(counters[0].problems, PROBLEM_NAN); \
    atomicMax(counters[0].badParticle, particle)
