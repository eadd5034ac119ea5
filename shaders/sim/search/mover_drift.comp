// One thread a mover: asks for a new search if its farthest particle is too far from where its contacts were found.
// Where bodies are animated, also notes whether there is any mover that could answer to a contact.
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/bodies/movers.glsl"
#include "sim/common/contacts/search_margin.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer searchCentres;
uniform samplerBuffer searchRotations;
BUFFER(Counters, CountersBlock, counters);

/// An upper bound of how far its farthest particle has moved since its candidates were found.
float drift(uint m, SearchCentre found, vec3 centre, vec4 rotation)
{
    vec4 since = quaternionProduct(rotation, conjugate(texelFetch(searchRotations, int(m))));
    return length(centre - found.position) + 2.0 * length(since.xyz) * moverRadius(m);
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    if (sim.animatedCount > 0u && !isTold(m)) counters[0].freeMoved = 1u;
    if (!moves(m)) return;
    vec3 centre = fetchCentre(m) + fetchMove(m).shift;
    vec4 rotation = quaternionProduct(fetchRotationDelta(m), fetchRotation(m));
    SearchCentre found = fetchSearchCentre(searchCentres, m);
    if (fetchMover(m).rankCount > 0u && drift(m, found, centre, rotation) > found.margin) counters[0].due = 1u;
}
