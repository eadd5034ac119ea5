// One thread a link: one step of the paper's reduction (eq. 10): every second partial sum of a block takes in its
// neighbour `stride` elements on. After ceil(log2 p) steps the first element of a block holds the sum.
#include "shared/kernel.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
layout(location = 0) uniform uint stride;
BUFFER(vec4, LinkTerms, linkTerms);

void main()
{
    uint l = gl_GlobalInvocationID.x;
    if (l >= step.linkCount) return;
    LinkValues link = fetchLink(l);
    uint k = l - link.blockStart;
    if (k % (2u * stride) != 0u || k + stride >= link.blockCount) return;
    for (uint term = 0u; term < 3u; ++term) linkTerms[3u * l + term] += linkTerms[3u * (l + stride) + term];
}
