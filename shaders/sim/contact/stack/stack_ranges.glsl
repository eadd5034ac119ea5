// Which bodies a thread of a stack works on.
READ_BUFFER(uvec4, StackSizes, stackSizes);
READ_BUFFER(uvec4, StackRanges, stackRanges);

/// Whether there is a stack of that number, and it has not been given up.
bool isSolved(uint index)
{
    return index < stackSizes[STACKS_SIZE].w && inStack(stackOrder[stackRanges[index].x]);
}
