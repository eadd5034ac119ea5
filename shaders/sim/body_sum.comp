// One thread a body: its mass centre c and the matrix A of eq. 9, summed over its block of links. About the last
// centre, so that single precision is spent on the difference; as the r of a body sum to zero, A needs no c.
#include "shared/kernel.glsl"
#include "shared/links.glsl"

layout(local_size_x = GROUP_SIZE) in;
uniform samplerBuffer moved;             // w: acting contacts
uniform samplerBuffer linkOffsets;
uniform usamplerBuffer bodyInfo;
uniform usamplerBuffer bodyAssemblies;
uniform usamplerBuffer assemblyState;
BUFFER(vec4, BodyCentres, bodyCentres);  // w: contacts of the body
BUFFER(vec4, BodyMatrices, bodyMatrices);  // columns of A, three a body

void main()
{
    uint b = gl_GlobalInvocationID.x;
    if (b >= step.bodyCount) return;
    uvec4 info = texelFetch(bodyInfo, int(b));
    uint order = texelFetch(assemblyState, int(texelFetch(bodyAssemblies, int(b)).x)).y;
    float factor = forceFactor(order);
    vec3 reference = bodyCentres[b].xyz;
    vec4 centre = vec4(0);
    float contacts = 0.0;
    mat3 a = mat3(0);
    for (uint k = 0u; k < info.y; ++k) {
        LinkValues link = fetchLink(info.x + k);
        vec4 x = texelFetch(moved, int(link.particle));
        vec3 from = x.xyz - reference;
        if (k >= info.z) from += factor * texelFetch(linkOffsets, int(info.x + k)).xyz;
        vec3 weighted = link.mass * from;
        centre += vec4(weighted, link.mass);
        a += outerProduct(weighted, link.r);
        contacts += x.w;
    }
    bodyCentres[b] = vec4(reference + centre.xyz / centre.w, contacts);
    for (int column = 0; column < 3; ++column) bodyMatrices[3u * b + uint(column)] = vec4(a[column], 0);
}
