// One thread a body: takes the sums that the paper's reduction left in the first element of its block.
#include "sim/common/kernel.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyInfo;
uniform samplerBuffer linkTerms;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    int first = int(3u * texelFetch(bodyInfo, int(b)).x);
#ifdef CENTRES
    vec4 centre = texelFetch(linkTerms, first);
    moverMoves[b] = vec4(moverMoves[b].xyz + centre.xyz / centre.w, 0);
#else
    for (int column = 0; column < 3; ++column)
        bodyMatrices[3u * b + uint(column)] = vec4(texelFetch(linkTerms, first + column).xyz, 0);
#endif
}
