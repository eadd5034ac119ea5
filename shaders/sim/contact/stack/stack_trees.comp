// One work group: finds stacks. Bodies that touch at most one other are taken off, round by round; what is left forms
// rings. Stacks are listed with parents behind their children. What would take too many rounds is left to the ordinary
// contacts.
#include "sim/common/kernel.glsl"
#include "shared/stack_records.h"
#include "sim/common/groups.glsl"

layout(local_size_x = STACK_GROUP) in;
READ_BUFFER(uint, StackTouches, stackTouches);
layout(std430) coherent buffer StackRounds { uint stackRounds[]; };      // that a body is taken off in; 0: no part
layout(std430) coherent buffer StackMembers { uint stackMembers[]; };    // of the stack of a body
layout(std430) coherent buffer StackParents { uvec4 newStackParents[]; };
BUFFER(uint, StackOrder, stackOrder);
BUFFER(uvec4, StackRanges, stackRanges);
BUFFER(uvec4, StackSizes, stackSizes);
shared uint changed, stackCount, memberCount;
#include "sim/contact/stack/stack_group.glsl"

/// How many bodies that a body touches are left when a round begins. @param last the last of them.
uint leftBeside(uint b, uint round, out uint last)
{
    uint count = 0u;
    last = STACK_ROOT;
    for (uint k = 0u; k < STACK_TOUCHES; ++k) {
        uint other = stackTouches[STACK_TOUCHES * b + k];
        if (other == NONE) break;
        if (stackRounds[other] < round) continue;
        ++count;
        last = other;
    }
    return count;
}

void takeOff(uint b, uint round)
{
    uint parent, next;
    uint count = leftBeside(b, round, parent);
    if (count > 1u) return;
    // Of the last two, one waits.
    if (count == 1u && b < parent && leftBeside(parent, round, next) == 1u) return;
    stackRounds[b] = round;
    newStackParents[b].x = parent;
    changed = 1u;
}

#include "sim/contact/stack/stack_rings.glsl"

void list(uint root)
{
    uint end = atomicAdd(memberCount, stackMembers[root]) + stackMembers[root], first = end - 1u;
    stackOrder[first] = root;
    for (uint i = end; i-- > first;) {
        uint b = stackOrder[i];
        for (uint k = 0u; k < STACK_TOUCHES; ++k) {
            uint other = stackTouches[STACK_TOUCHES * b + k];
            if (other == NONE) break;
            if (newStackParents[other].x == b) stackOrder[--first] = other;
        }
    }
    for (uint i = first; i < end; ++i) stackMembers[stackOrder[i]] = end - first;
    stackRanges[atomicAdd(stackCount, 1u)] = uvec4(first, end, loopsOf(root), 0);
}

void main()
{
    bool leads = gl_LocalInvocationID.x == 0u;
    if (leads) stackCount = memberCount = 0u;
    uint round = 0u;
    do {
        BEGIN_ROUND
        ++round;
        FOR_BODIES(b) if (stackRounds[b] == NONE) takeOff(b, round);
        MEET
    } while (goesOn());
    spanRings();
    FOR_BODIES(b) {
        uint root = rootOf(b);
        if (root != NONE) atomicAdd(stackMembers[root], 1u);
    }
    MEET
    uint listed = 0u;   // by this thread: that takes rounds, too
    FOR_BODIES(b) if (rootOf(b) == b) {
        uint count = stackMembers[b];
        bool isStack = count >= LEAST_STACK && count <= MOST_STACK && listed + count <= 4u * MOST_STACK;
        if (isStack) list(b);
        else stackMembers[b] = 0u;
        listed += isStack ? count : 0u;
    }
    MEET
    FOR_BODIES(b) if (stackMembers[b] < LEAST_STACK) newStackParents[b] = uvec4(NONE);
    if (!leads) return;
    stackSizes[STACKS_SIZE] = uvec4((stackCount + TREE_GROUP_SIZE - 1u) / TREE_GROUP_SIZE, 1, 1, stackCount);
    stackSizes[STACK_BODIES_SIZE] = uvec4(groups(memberCount), 1, 1, memberCount);
}
