// One thread a link: the first step of the paper's reduction (eq. 10). CENTRES: a link's part of the centre's move;
// otherwise its part of A (eq. 9).
#include "sim/common/kernel.glsl"
#include "sim/common/bodies/bodies.glsl"
#include "sim/paper/body_shape.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moverMoves;
BUFFER(vec4, LinkTerms, linkTerms);      // three a link

void main()
{
    uint l = gl_GlobalInvocationID.x;
    if (l >= sim.linkCount) return;
    LinkValues link = fetchLink(l);
    bool isShared = l - link.blockStart >= fetchBody(link.body).ownCount;
    LinkPosition position = linkPosition(l, link, isShared);
#ifdef CENTRES
    linkTerms[3u * l] = link.mass * vec4(position.move - texelFetch(moverMoves, int(link.body)).xyz, 1);
#else
    for (int column = 0; column < 3; ++column)
        linkTerms[3u * l + uint(column)] = vec4(link.mass * position.arm * link.r[column], 0);
#endif
}
