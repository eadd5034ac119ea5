// One thread a mover: lists the bodies that a body without joints touches. Balls and capsules, and bodies that touch
// too many others or have sunk into one, are not for stacks.
#include "sim/common/kernel.glsl"
#include "shared/stack_records.h"
#include "sim/common/bodies/bodies.glsl"
#include "sim/common/bodies/mover_info.glsl"
#include "sim/common/contacts/list_ranges.glsl"
#include "sim/common/contacts/round_bodies.glsl"
#include "sim/contact/stack/stack_faces.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer pairs;
uniform usamplerBuffer pairSides;
uniform samplerBuffer pairArms;
uniform usamplerBuffer pairReferences;
uniform samplerBuffer pairImpulses;
READ_BUFFER(Counters, CountersBlock, counters);
BUFFER(uint, StackTouches, stackTouches);
BUFFER(uint, StackRounds, stackRounds);
BUFFER(uint, StackMembers, stackMembers);
BUFFER(uvec4, StackParents, newStackParents);

bool isPart(uint m)
{
    return m < sim.bodyCount && responds(m) && !hasJoints(m) && fetchRound(m).radius == 0.0;
}

/// Notes the other side of a pair, if the two touch and it may be part of a stack.
void note(uint m, uint parity, uint q, inout uint count)
{
    ContactSides sides = fetchContactSides(pairSides, q);
    uint other = sides.movers.x == m ? sides.movers.y : sides.movers.x, index = parity * sim.pairCapacity + q;
    if (!isPart(other)) return;
    FacePair faces = facePair(fetchPair(pairs, index), sides, fetchContactArm(pairArms, firstArm(q)).r,
                              fetchContactArm(pairArms, secondArm(q)).r);
    if (faces.startGap > TOUCHING * sim.diameter) return;
    if (faces.startGap < -MOST_OVERLAP * sim.diameter) count = STACK_TOUCHES + 1u;
    for (uint k = 0u; k < min(count, STACK_TOUCHES); ++k)
        if (stackTouches[STACK_TOUCHES * m + k] == other) return;
    if (count < STACK_TOUCHES) stackTouches[STACK_TOUCHES * m + count] = other;
    ++count;
}

void main()
{
    uint m = gl_GlobalInvocationID.x;
    if (m >= sim.moverCount) return;
    newStackParents[m] = uvec4(NONE);
    if (m >= sim.bodyCount) return;
    stackMembers[m] = stackRounds[m] = 0u;
    if (!isPart(m)) return;
    Mover mover = fetchMover(m);
    uint parity = counters[0].listParity, count = 0u;
    uvec2 range = listRange(parity, LIST_AS_FIRST, mover.firstRank, mover.rankCount);
    for (uint q = range.x; q < range.y; ++q) note(m, parity, q, count);
    range = listRange(parity, LIST_AS_SECOND, mover.firstRank, mover.rankCount);
    for (uint k = range.x; k < range.y; ++k) {
        uint q = texelFetch(pairReferences, int(k)).x;
        if (q != NONE) note(m, parity, q, count);
    }
    if (count < STACK_TOUCHES) stackTouches[STACK_TOUCHES * m + count] = NONE;
    if (count <= STACK_TOUCHES) stackRounds[m] = NONE;
}
