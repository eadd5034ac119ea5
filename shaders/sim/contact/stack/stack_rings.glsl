// Bodies that form rings get a tree, too, breadth first from the first of each; their other touches are its loops.

// stackRounds[] of a body of a ring from here on: which step of the tree it is, of the first how many loops there are;
// NONE before it is known.
#define RINGS 0x80000000u

uint loopsOf(uint root)
{
    return stackRounds[root] < RINGS ? 0u : stackRounds[root] - RINGS;
}

/// The body that a stack hangs on; NONE if it has too many loops.
uint rootOf(uint b)
{
    while (newStackParents[b].x < STACK_ROOT) b = newStackParents[b].x;
    return newStackParents[b].x == STACK_ROOT && loopsOf(b) <= MOST_LOOPS ? b : NONE;
}

#define FOR_NEIGHBOURS(b, other) \
    for (uint n = 0u, other; n < STACK_TOUCHES && (other = stackTouches[STACK_TOUCHES * b + n]) != NONE; ++n) \
        if (stackRounds[other] >= RINGS)

/// Hangs a body on the first of those that it touches that the last step has reached.
void hang(uint b, uint step)
{
    uint parent = NONE;
    FOR_NEIGHBOURS(b, other) if (stackRounds[other] == RINGS + step - 1u) parent = min(parent, other);
    if (parent == NONE) return;
    newStackParents[b].x = parent;
    stackRounds[b] = RINGS + step;
    changed = 1u;
}

/// Notes a body's loops with those before it.
void noteLoops(uint b)
{
    uint count = 0u;
    FOR_NEIGHBOURS(b, other) {
        if (other > b || newStackParents[b].x == other || newStackParents[other].x == b) continue;
        if (count < BODY_LOOPS) newStackParents[b][1u + count] = other;
        count += count < BODY_LOOPS ? 1u : MOST_LOOPS;
    }
    uint root = b;
    while (newStackParents[root].x < STACK_ROOT) root = newStackParents[root].x;
    if (count > 0u) atomicAdd(stackRounds[root], count);
}

/// The first body that can be reached from each becomes the root of its tree.
void findRoots()
{
    FOR_BODIES(b) stackMembers[b] = b;
    do {
        BEGIN_ROUND
        FOR_BODIES(b) {
            if (stackRounds[b] < RINGS) continue;
            uint least = stackMembers[b];
            FOR_NEIGHBOURS(b, other) least = min(least, stackMembers[other]);
            if (least == stackMembers[b]) continue;
            stackMembers[b] = least;
            changed = 1u;
        }
        MEET
    } while (goesOn());
    FOR_BODIES(b) {
        if (stackRounds[b] < RINGS || stackMembers[b] != b) continue;
        newStackParents[b].x = STACK_ROOT;
        stackRounds[b] = RINGS;
    }
}

void spanRings()
{
    // Roots are found in as many rounds as their trees are deep, or in fewer, by chance: trees have one less.
    uint most = mostRounds(), step = 0u;
    roundsLeft = most;
    findRoots();
    bool found = roundsLeft > 0u;
    roundsLeft = most - 1u;
    do {
        BEGIN_ROUND
        ++step;
        FOR_BODIES(b) if (stackRounds[b] == NONE) hang(b, step);
        MEET
    } while (goesOn());
    found = found && roundsLeft > 0u;
    FOR_BODIES(b) if (stackRounds[b] >= RINGS) {
        if (found) noteLoops(b);
        else newStackParents[b] = uvec4(NONE);
    }
    FOR_BODIES(b) stackMembers[b] = 0u;
    MEET
}
