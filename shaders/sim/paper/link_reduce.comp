// One thread a partial sum: one round of the paper's reduction (eq. 10): every second partial sum of a block adds its
// neighbour `stride` links on. After ceil(log2 p) steps the first link of a block holds the sum. CENTRES: only for the
// first of a link's three terms.
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uvec3 reduction;   // first and last of reductionLinks, stride
uniform usamplerBuffer reductionLinks;
uniform samplerBuffer lastLinkTerms;     // no other thread writes what this one reads
BUFFER(vec4, LinkTerms, linkTerms);

#ifdef CENTRES
#define TERMS 1u
#else
#define TERMS 3u
#endif

void main()
{
    uint k = reduction.x + gl_GlobalInvocationID.x;
    if (k >= reduction.y) return;
    uint l = texelFetch(reductionLinks, int(k)).x;
    for (uint term = 0u; term < TERMS; ++term)
        linkTerms[3u * l + term] = texelFetch(lastLinkTerms, int(3u * l + term)) +
                                   texelFetch(lastLinkTerms, int(3u * (l + reduction.z) + term));
}
