// Which slots a kernel works on: all of them; FREE: those of fluid near which is nothing but fluid; WALLED: those near
// colliders only; COVERED: those near solid particles. What walls and solids do takes a software driver as long where
// there are none.
#include "shared/slot_lists.h"

#if defined(FREE)
uniform usamplerBuffer freeSlots;
#define LISTED_SLOTS freeSlots
#define LIST_SIZE FREE_SLOTS_SIZE
#elif defined(WALLED)
uniform usamplerBuffer walledSlots;
#define LISTED_SLOTS walledSlots
#define LIST_SIZE WALLED_SLOTS_SIZE
#define WALLS
#else
#define WALLS
#define SOLIDS
#ifdef COVERED
uniform usamplerBuffer coveredSlots;
#define LISTED_SLOTS coveredSlots
#define LIST_SIZE COVERED_SLOTS_SIZE
#endif
#endif

#ifdef LISTED_SLOTS
uniform usamplerBuffer slotListSizes;
uint listedSlots() { return texelFetch(slotListSizes, LIST_SIZE).w; }
uint listedSlot(uint n) { return texelFetch(LISTED_SLOTS, int(n)).x; }
#else
uint listedSlots() { return slotCount(); }
uint listedSlot(uint n) { return n; }
#endif
