// One thread a mover: its place for finding contacts, and how far it may drift from there. The place lies ahead on its
// way, by most of its margin, so that it stays near for longer. FROM_POSITIONS: of the paper's solver, which has places
// per particle; only the mover's rotation.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/search_margin.glsl"
#ifndef FROM_POSITIONS
uniform samplerBuffer moverReaches;
BUFFER(Counters, CountersBlock, counters);
BUFFER(vec4, SearchCentres, searchCentres);
#endif

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, SearchRotations, searchRotations);

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
#ifdef FROM_POSITIONS
    searchRotations[m] = fetchRotation(m);
#else
    vec3 move = fetchMove(m).shift;
    float reach = counters[0].fastCount <= sim.fastLimit ? texelFetch(moverReaches, int(m)).x : 0.0;
    float margin = sim.drift + reach;
    vec3 ahead = move * min(sim.lookAhead, 0.75 * margin / max(length(move), 1e-20));
    searchCentres[m] = packSearchCentre(SearchCentre(fetchCentre(m) + move + ahead, margin));
    searchRotations[m] = quaternionProduct(fetchRotationDelta(m), fetchRotation(m));
#endif
}
