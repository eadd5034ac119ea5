// Each thread handles a run of particles. No run holds both solids and fluids; the runs of fluids come last.
#include "render/common/frame.glsl"

struct Run {
    uint begin, end;    // particles
    uint first;         // particle of its group
};

uint runCount(uint particleCount)
{
    return (particleCount + LIST_CHUNK - 1u) / LIST_CHUNK;
}

// Empty beyond the last one.
Run runAt(uint index)
{
    uint solidRuns = runCount(frame.solidCount);
    bool solid = index < solidRuns;
    uint first = solid ? 0u : frame.solidCount;
    uint begin = first + LIST_CHUNK * (solid ? index : index - solidRuns);
    return Run(begin, min(begin + LIST_CHUNK, solid ? frame.solidCount : frame.particleCount), first);
}
