// One thread a body: takes the sums that the paper's reduction left with the first link of its block. CENTRES: the
// centre's move; otherwise the matrix A.
#include "sim/common/kernel.glsl"
#include "sim/paper/body_sums.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer linkTerms;         // three a link
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    int first = int(3u * fetchBody(b).linkStart);
#ifdef CENTRES
    moverMoves[b] = vec4(moverMoves[b].xyz + meanMove(texelFetch(linkTerms, first)), 0);
#else
    for (int column = 0; column < 3; ++column)
        bodyMatrices[3u * b + uint(column)] = vec4(texelFetch(linkTerms, first + column).xyz, 0);
#endif
}
