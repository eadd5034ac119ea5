// One work group a body: the sums of body_sum, each thread over every BODY_GROUP_SIZE-th link, then a tree in shared
// memory. For devices where groups are cheap and for large bodies.
#include "sim/common/kernel.glsl"
#include "sim/paper/body_sums.glsl"

layout(local_size_x = BODY_GROUP_SIZE) in;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);

shared vec4 centres[BODY_GROUP_SIZE];
shared vec3 columns[3][BODY_GROUP_SIZE];

void main()
{
    uint b = gl_WorkGroupID.x;
    uint t = gl_LocalInvocationID.x;
    Body body = fetchBody(b);
    vec3 last = moverMoves[b].xyz;
    BodySum sum = BodySum(vec4(0), mat3(0));
    for (uint k = t; k < body.linkCount; k += BODY_GROUP_SIZE) addLink(sum, body, k, last);
    centres[t] = sum.centre;
    for (int column = 0; column < 3; ++column) columns[column][t] = sum.a[column];
    for (uint stride = BODY_GROUP_SIZE / 2; stride > 0u; stride >>= 1) {
        barrier();
        if (t < stride) {
            centres[t] += centres[t + stride];
            for (int column = 0; column < 3; ++column) columns[column][t] += columns[column][t + stride];
        }
    }
    if (t != 0u) return;
    moverMoves[b] = vec4(last + meanMove(centres[0]), 0);
    for (int column = 0; column < 3; ++column)
        bodyMatrices[3u * b + uint(column)] = vec4(columns[column][0], 0);
}
