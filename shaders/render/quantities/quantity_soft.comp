// One thread a particle: the mean strain of the clusters that it is part of.
#include "render/quantities/input.glsl"

uniform usamplerBuffer clusterStarts;    // per particle, and an end
uniform usamplerBuffer particleClusters;
uniform samplerBuffer clusterStrains;

void main()
{
    uint i = gl_GlobalInvocationID.x;
    if (i >= frame.particleCount) return;
    uint first = texelFetch(clusterStarts, int(i)).x, end = texelFetch(clusterStarts, int(i) + 1).x;
    float sum = 0.0;
    for (uint k = first; k < end; ++k) sum += texelFetch(clusterStrains, int(texelFetch(particleClusters, int(k)).x)).x;
    shownQuantities[i] = end > first ? sum / float(end - first) : NO_QUANTITY;
}
