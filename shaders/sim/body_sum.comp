// One thread a body: how far its mass centre c moves in the substep and the matrix A of eq. 9, summed over its block of
// links. A is taken about the centre before the substep: as the r of a body sum to zero, it needs no other. The centre's
// move is summed from the particles' moves alone, so that rounding of positions never reaches the momentum.
#include "shared/kernel.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer positions;
uniform samplerBuffer moved;             // w: acting contacts
uniform samplerBuffer linkOffsets;
uniform usamplerBuffer bodyInfo;
uniform usamplerBuffer bodyAssemblies;
uniform usamplerBuffer assemblyState;
uniform samplerBuffer bodyStarts;        // centre, rotation at the start of the substep
BUFFER(vec4, BodyMoves, bodyMoves);      // w: contacts of the body
BUFFER(vec4, BodyMatrices, bodyMatrices);  // columns of A, three a body

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= step.bodyCount) return;
    uvec4 info = texelFetch(bodyInfo, int(b));
    uint order = texelFetch(assemblyState, int(texelFetch(bodyAssemblies, int(b)).x)).y;
    float factor = forceFactor(order);
    vec3 reference = texelFetch(bodyStarts, int(2u * b)).xyz;
    vec4 centre = vec4(0);
    float contacts = 0.0;
    mat3 a = mat3(0);
    for (uint k = 0u; k < info.y; ++k) {
        LinkValues link = fetchLink(info.x + k);
        vec4 x = texelFetch(moved, int(link.particle));
        if (k >= info.z) x.xyz += factor * texelFetch(linkOffsets, int(info.x + k)).xyz;
        vec3 from = texelFetch(positions, int(link.particle)).xyz - reference + x.xyz;
        centre += link.mass * vec4(x.xyz, 1);
        a += outerProduct(link.mass * from, link.r);
        contacts += x.w;
    }
    bodyMoves[b] = vec4(centre.xyz / centre.w, contacts);
    for (int column = 0; column < 3; ++column) bodyMatrices[3u * b + uint(column)] = vec4(a[column], 0);
}
