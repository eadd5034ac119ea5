// One thread a link: the first step of the paper's reduction (eq. 10). CENTRES: a link's part of the centre's move
// and the contacts; otherwise its part of A (eq. 9).
#include "shared/kernel.glsl"
#include "shared/body_shape.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform usamplerBuffer bodyInfo;
uniform usamplerBuffer bodyAssemblies;
uniform usamplerBuffer assemblyState;
uniform samplerBuffer bodyMoves;
BUFFER(vec4, LinkTerms, linkTerms);      // three a link

void main()
{
    uint l = gl_GlobalInvocationID.x;
    if (l >= step.linkCount) return;
    LinkValues link = fetchLink(l);
    uint order = texelFetch(assemblyState, int(texelFetch(bodyAssemblies, int(link.body)).x)).y;
    vec4 x = texelFetch(moved, int(link.particle));
    bool isShared = l - link.blockStart >= texelFetch(bodyInfo, int(link.body)).z;
    vec3 move = linkMove(l, isShared, x.xyz, forceFactor(order));
#ifdef CENTRES
    linkTerms[3u * l] = link.mass * vec4(move - texelFetch(bodyMoves, int(link.body)).xyz, 1);
    linkTerms[3u * l + 1u] = vec4(x.w, 0, 0, 0);
    linkTerms[3u * l + 2u] = vec4(0);
#else
    vec3 arm = linkArm(link, l, isShared, move);
    for (int column = 0; column < 3; ++column)
        linkTerms[3u * l + uint(column)] = vec4(link.mass * arm * link.r[column], 0);
#endif
}
