// The sum over a work group, of one form.

shared float groupParts[GROUP_SIZE];

/// The sum of the threads' parts, returned in the first thread of the group.
float groupSum(float part)
{
    uint thread = gl_LocalInvocationIndex;
    groupParts[thread] = part;
    for (uint stride = GROUP_SIZE / 2u; stride > 0u; stride /= 2u) {
        barrier();
        if (thread < stride) groupParts[thread] += groupParts[thread + stride];
    }
    barrier();
    return groupParts[0];
}
