// One thread a link: one step of the paper's reduction (eq. 10): every second partial sum of a block takes in its
// neighbour `stride` elements on. After ceil(log2 p) steps the first element of a block holds the sum. CENTRES: of the
// first of a link's three terms only.
#include "shared/kernel.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uint stride;
uniform samplerBuffer lastLinkTerms;     // no other thread writes what this one reads
BUFFER(vec4, LinkTerms, linkTerms);

#ifdef CENTRES
#define TERMS 1u
#else
#define TERMS 3u
#endif

void main()
{
    uint l = gl_GlobalInvocationID.x;
    if (l >= step.linkCount) return;
    LinkValues link = fetchLink(l);
    uint k = l - link.blockStart;
    if (k % (2u * stride) != 0u || k + stride >= link.blockCount) return;
    for (uint term = 0u; term < TERMS; ++term)
        linkTerms[3u * l + term] = texelFetch(lastLinkTerms, int(3u * l + term)) +
                                   texelFetch(lastLinkTerms, int(3u * (l + stride) + term));
}
