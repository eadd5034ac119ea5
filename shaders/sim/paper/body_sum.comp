// One thread a body: how far its mass centre c moves in the substep and the matrix A of eq. 9, summed over its block of
// links. A is taken about the centre before the substep: as the r of a body sum to zero, it needs no other. The
// centre's move is summed from the particles' moves alone, about its last value, so that rounding never reaches the
// momentum.
#include "sim/common/kernel.glsl"
#include "sim/paper/body_shape.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform usamplerBuffer bodyInfo;
BUFFER(vec4, MoverMoves, moverMoves);
BUFFER(vec4, BodyMatrices, bodyMatrices);  // columns of A, three a body

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= sim.bodyCount) return;
    uvec4 info = texelFetch(bodyInfo, int(b));
    vec3 last = moverMoves[b].xyz;
    vec4 centre = vec4(0);
    mat3 a = mat3(0);
    for (uint k = 0u; k < info.y; ++k) {
        LinkValues link = fetchLink(info.x + k);
        LinkPlace place = linkPlace(info.x + k, link, k >= info.z);
        centre += link.mass * vec4(place.move - last, 1);
        a += outerProduct(link.mass * place.arm, link.r);
    }
    moverMoves[b] = vec4(last + centre.xyz / centre.w, 0);
    for (int column = 0; column < 3; ++column) bodyMatrices[3u * b + uint(column)] = vec4(a[column], 0);
}
