// Which slots a kernel works on: all of them; FREE: those of fluid near which is nothing but fluid; COVERED: those of
// other fluid. What walls and solids do takes a software driver as long where there are none.
#include "shared/slot_lists.h"

#if defined(FREE)
uniform usamplerBuffer slotListSizes;
uniform usamplerBuffer freeSlots;
uint listedSlots() { return texelFetch(slotListSizes, FREE_SLOTS_SIZE).w; }
uint listedSlot(uint n) { return texelFetch(freeSlots, int(n)).x; }
#elif defined(COVERED)
uniform usamplerBuffer slotListSizes;
uniform usamplerBuffer coveredSlots;
uint listedSlots() { return texelFetch(slotListSizes, COVERED_SLOTS_SIZE).w; }
uint listedSlot(uint n) { return texelFetch(coveredSlots, int(n)).x; }
#else
uint listedSlots() { return slotCount(); }
uint listedSlot(uint n) { return n; }
#endif
