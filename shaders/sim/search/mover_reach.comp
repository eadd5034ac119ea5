// One thread a mover: how much further it looks for contacts than others, if it will soon leave its margin (a fast
// mover: otherwise a few would set the pace of all). CALM: a body that moves little looks less far.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(float, MoverReaches, moverReaches);
BUFFER(Counters, CountersBlock, counters);

// How far a calm body looks: so many horizons, and at least this part of the common margin.
const float CALM_SIGHT = 6.0, LEAST_MARGIN = 0.4;

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    float radius = moverRadius(m);
    // search_centre looks ahead by three quarters of the margin, so the margin lasts for 1.75 times its length. It does
    // not look ahead of rotations.
    float path = length(fetchMove(m).shift) / 1.75 +
                 2.0 * length(fetchRotationDelta(m).xyz) * radius;
    bool farSighted = counters[0].farSighted == 1u;
    float missing = (farSighted ? FAR_SIGHT : 1.0) * sim.horizon * path - sim.drift;
    float least = 0.0;
#ifdef CALM
    if (m < sim.bodyCount) least = min(max(CALM_SIGHT * sim.horizon * path, LEAST_MARGIN * sim.drift) - sim.drift, 0.0);
#endif
    float reach = clamp(missing, least, sim.farReach);
    moverReaches[m] = reach;
    uint particles = fetchMover(m).rankCount;
    if (reach > 0.0) atomicAdd(counters[0].fastCount, particles);
    if (FAR_SIGHT * sim.horizon * path > sim.drift) atomicAdd(counters[0].fastLater, particles);
}
