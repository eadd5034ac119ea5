// How a stack takes its steps, and when it is given up.

// A stack whose step is longer is given up until the next search for stacks: its contacts have not agreed, as in a blow
// or a fall, and what they don't agree on would be energy [rad and diameters].
#ifdef FIRST
#define MOST_STEP 0.05
#elif defined(ENDS)
#define MOST_STEP 1e-4
#else
#define MOST_STEP 0.01
#endif

BUFFER(uvec4, StackParents, newStackParents);

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
