// Tells the host that a particle's velocity is no finite number any more. A macro, for `counters` is a block of the
// kernel.
#define REPORT_NAN(particle) \
    atomicOr(counters[0].problems, PROBLEM_NAN); \
    atomicMax(counters[0].badParticle, particle)
