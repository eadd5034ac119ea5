// One thread a slot: lists those of fluid particles, apart by whether walls or solids are near them. Slots of one work
// group stand together, since their neighbours do; the groups' order does not matter.
#include "sim/common/kernel.glsl"
#include "sim/fluid/fluid_slots.glsl"
#include "shared/slot_lists.h"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer slotColliders;
BUFFER(uvec4, SlotListSizes, slotListSizes);
BUFFER(uint, FreeSlots, freeSlots);
BUFFER(uint, WalledSlots, walledSlots);
BUFFER(uint, CoveredSlots, coveredSlots);

/// By list: bits of the group's threads whose slots it gets, and the place of the first of these.
shared uvec2 listed[SLOT_LISTS];
shared uint firsts[SLOT_LISTS];

/// Room in a list, which begins the step empty. @returns its first place.
uint placesIn(uint list, uint count)
{
    if (count == 0u) return 0u;
    uint first = atomicAdd(slotListSizes[list].w, count);
    atomicMax(slotListSizes[list].x, (first + count + GROUP_SIZE - 1u) / GROUP_SIZE);
    return first;
}

void main()
{
    uint k = gl_GlobalInvocationID.x, thread = gl_LocalInvocationID.x, list = SLOT_LISTS;
    if (k < slotCount() && isFluid(fetchSlotParticle(k))) {
        bool walled = texelFetch(slotColliders, int(k)).x != 0u;
        list = fetchCounts(k).solids > 0u ? COVERED_SLOTS_SIZE : walled ? WALLED_SLOTS_SIZE : FREE_SLOTS_SIZE;
    }
    if (thread < SLOT_LISTS) listed[thread] = uvec2(0u);
    barrier();
    uint bit = 1u << (thread & 31u);
    if (list < SLOT_LISTS) atomicOr(listed[list][thread / 32u], bit);
    barrier();
    if (thread < SLOT_LISTS) {
        ivec2 counts = bitCount(listed[thread]);
        firsts[thread] = placesIn(thread, uint(counts.x + counts.y));
    }
    barrier();
    if (list == SLOT_LISTS) return;
    uvec2 own = listed[list];
    uvec2 before = thread < 32u ? uvec2(own.x & bit - 1u, 0u) : uvec2(own.x, own.y & bit - 1u);
    uint place = firsts[list] + uint(bitCount(before.x) + bitCount(before.y));
    if (list == COVERED_SLOTS_SIZE) coveredSlots[place] = k;
    else if (list == WALLED_SLOTS_SIZE) walledSlots[place] = k;
    else freeSlots[place] = k;
}
