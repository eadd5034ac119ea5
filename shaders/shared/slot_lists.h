// Lists of the slots of fluid particles: slotListSizes[] has the work groups of each, and how many there are in w.
#ifndef KNUCKLE_SLOT_LISTS_H
#define KNUCKLE_SLOT_LISTS_H

#define FREE_SLOTS_SIZE 0
#define WALLED_SLOTS_SIZE 1
#define COVERED_SLOTS_SIZE 2
#define SLOT_LISTS 3

#endif
