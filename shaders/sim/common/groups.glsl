// Sizes of the dispatches that the GPU decides, as groupsFor() on the host.

uint groups(uint threads)
{
    return (threads + GROUP_SIZE - 1u) / GROUP_SIZE;
}
