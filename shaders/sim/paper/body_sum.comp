// One thread a body: how far its mass centre c moves in the substep and the matrix A of eq. 9, summed over its block of
// links. A is taken about the centre before the substep, which suffices since the r of a body sum to zero. The centre's
// move is summed from the particles' moves alone, about its last value, so that rounding never reaches the momentum.
#include "sim/common/kernel.glsl"
#include "sim/paper/body_sums.glsl"

layout(local_size_x = GROUP_SIZE) in;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);  // columns of A, three a body

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    Body body = fetchBody(b);
    vec3 last = moverMoves[b].xyz;
    BodySum sum = BodySum(vec4(0), mat3(0));
    for (uint k = 0u; k < body.linkCount; ++k) addLink(sum, body, k, last);
    moverMoves[b] = vec4(last + meanMove(sum.centre), 0);
    for (int column = 0; column < 3; ++column) bodyMatrices[3u * b + uint(column)] = vec4(sum.a[column], 0);
}
