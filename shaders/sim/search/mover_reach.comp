// One thread a mover: how much further it looks for contacts than others, if it will soon leave its margin (a fast
// mover: otherwise a few would set the pace of all).
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(float, MoverReaches, moverReaches);
BUFFER(Counters, CountersBlock, counters);

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
    float reach = clamp(missing, 0.0, sim.farReach);
    moverReaches[m] = reach;
    uint particles = fetchMover(m).rankCount;
    if (reach > 0.0) atomicAdd(counters[0].fastCount, particles);
    if (FAR_SIGHT * sim.horizon * path > sim.drift) atomicAdd(counters[0].fastLater, particles);
}
