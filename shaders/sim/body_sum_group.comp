// One work group a body: the sums of body_sum, each thread over every BODY_GROUP_SIZE-th link, then a tree in shared
// memory. For devices where groups are cheap and for large bodies.
#include "shared/kernel.glsl"
#include "shared/body_shape.glsl"

layout(local_size_x = BODY_GROUP_SIZE) in;
uniform samplerBuffer moved;
uniform usamplerBuffer bodyInfo;
uniform usamplerBuffer bodyAssemblies;
uniform usamplerBuffer assemblyState;
BUFFER(vec4, BodyMoves, bodyMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);

shared vec4 centres[BODY_GROUP_SIZE];
shared vec4 columns[3][BODY_GROUP_SIZE];   // w of the first: contacts

void main()
{
    uint b = gl_WorkGroupID.x;
    uint t = gl_LocalInvocationID.x;
    uvec4 info = texelFetch(bodyInfo, int(b));
    uint order = texelFetch(assemblyState, int(texelFetch(bodyAssemblies, int(b)).x)).y;
    float factor = forceFactor(order);
    vec3 last = bodyMoves[b].xyz;
    vec4 centre = vec4(0);
    float contacts = 0.0;
    mat3 a = mat3(0);
    for (uint k = t; k < info.y; k += BODY_GROUP_SIZE) {
        LinkValues link = fetchLink(info.x + k);
        vec4 x = texelFetch(moved, int(link.particle));
        bool isShared = k >= info.z;
        vec3 move = linkMove(info.x + k, isShared, x.xyz, factor);
        centre += link.mass * vec4(move - last, 1);
        a += outerProduct(link.mass * linkArm(link, info.x + k, isShared, move), link.r);
        contacts += x.w;
    }
    centres[t] = centre;
    columns[0][t] = vec4(a[0], contacts);
    columns[1][t] = vec4(a[1], 0);
    columns[2][t] = vec4(a[2], 0);
    for (uint stride = BODY_GROUP_SIZE / 2; stride > 0u; stride >>= 1) {
        barrier();
        if (t < stride) {
            centres[t] += centres[t + stride];
            for (int column = 0; column < 3; ++column) columns[column][t] += columns[column][t + stride];
        }
    }
    if (t != 0u) return;
    bodyMoves[b] = vec4(last + centres[0].xyz / centres[0].w, columns[0][0].w);
    for (int column = 0; column < 3; ++column)
        bodyMatrices[3u * b + uint(column)] = vec4(columns[column][0].xyz, 0);
}
