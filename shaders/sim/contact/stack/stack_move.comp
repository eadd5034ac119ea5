// One thread a stack: its bodies take the step of stack_solve, or it is given up.
// BEGINS, ENDS: the steps of an iteration. FIRST: those of a substep. AGAIN: of an iteration after the first.
#include "sim/common/kernel.glsl"
#include "math/quaternion.glsl"
#include "sim/common/contacts/stacks.glsl"
#include "sim/contact/stack/stack_blocks.glsl"

layout(local_size_x = TREE_GROUP_SIZE) in;
BUFFER(vec4, MoverMoves, newMoves);
BUFFER(vec4, MoverRotationDeltas, newDeltas);
BUFFER(uvec4, StackParents, newStackParents);
#include "sim/contact/stack/stack_ranges.glsl"

// A stack whose step is longer is given up until the next search for stacks: its contacts have not agreed, as in a blow
// or a fall, and what they don't agree on would be energy [rad and diameters].
#ifdef FIRST
#define MOST_STEP 0.05
#elif defined(ENDS)
#define MOST_STEP 1e-4
#else
#define MOST_STEP 0.01
#endif

/// How far a motion is [rad and diameters].
float sizeOf(Motion motion)
{
    return length(motion.r) + length(motion.t) / sim.diameter;
}

/// Where a body is before the first step.
void note(uint body)
{
    uint t = STACK_TEXELS * body + STACK_BEFORE;
    stackBlocks[t].xyz = newMoves[body].xyz;
    stackBlocks[t + 1u] = newDeltas[body];
}

void move(uint body)
{
    Motion motion = loadStep(body);
    newMoves[body].xyz += motion.t;
    newDeltas[body] = normalize(quaternionProduct(quaternionFromRotation(motion.r), newDeltas[body]));
}

/// Puts a body back to where it was before the steps of the iteration: where its contacts agreed, or, in the first one,
/// where they are left to the ordinary contacts until stacks are found again.
void giveUp(uint body)
{
    uint t = STACK_TEXELS * body + STACK_BEFORE;
    newMoves[body].xyz = stackBlocks[t].xyz;
    newDeltas[body] = stackBlocks[t + 1u];
#ifndef AGAIN
    newStackParents[body] = uvec4(NONE);
#endif
}

void main()
{
    uint index = gl_GlobalInvocationID.x;
    if (!isSolved(index)) return;
    uvec2 range = stackRanges[index].xy;
    float size = 0.0;
    for (uint k = range.x; k < range.y; ++k) {
#ifdef BEGINS
        note(stackOrder[k]);
#endif
        size = max(size, sizeOf(loadStep(stackOrder[k])));
    }
    for (uint k = range.x; k < range.y; ++k) {
        if (size < MOST_STEP) move(stackOrder[k]);
        else giveUp(stackOrder[k]);
    }
}
