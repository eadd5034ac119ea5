// One thread a mover: by how much further it looks for contacts than others, because it will soon have left its margin
// (a fast mover; the pace of all would else be set by a few).
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverMoves;
uniform samplerBuffer moverRotationDeltas;
uniform samplerBuffer bodyMoments;       // w of the first of three: radius
uniform usamplerBuffer moverInfo;
BUFFER(float, MoverReaches, moverReaches);
BUFFER(Counters, CountersBlock, counters);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    float radius = m < sim.bodyCount ? texelFetch(bodyMoments, int(3u * m)).w : 0.0;
    // search_position puts the middle of the way ahead: it lasts for 1.75 times its length. Turns are not looked ahead.
    float path = length(texelFetch(moverMoves, int(m)).xyz) / 1.75 +
                 2.0 * length(texelFetch(moverRotationDeltas, int(m)).xyz) * radius;
    bool calm = counters[0].calm == 1u;
    float missing = (calm ? CALM : 1.0) * sim.horizon * path - sim.drift;
    float reach = clamp(missing, 0.0, sim.farReach);
    moverReaches[m] = reach;
    uint particles = texelFetch(moverInfo, int(m)).y;
    if (reach > 0.0) atomicAdd(counters[0].fastCount, particles);
    if (CALM * sim.horizon * path > sim.drift) atomicAdd(counters[0].fastLater, particles);
}
