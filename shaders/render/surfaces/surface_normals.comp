// One thread a vertex: its normal is the sum of those of the triangles around it by their areas. Where one of them is
// torn away, cloth has no thickness, so that its two sides close.
#include "render/common/frame.glsl"
#include "shared/matter_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) writeonly buffer SurfaceNormals { vec4 normals[]; };    // w: half the thickness [m]
uniform usamplerBuffer surfaceIndices;
uniform usamplerBuffer surfaceFanStarts;    // per vertex, the first of its triangles
uniform usamplerBuffer surfaceFans;         // triangles
uniform samplerBuffer surfacePlaces;
uniform samplerBuffer surfaceLooks;         // z: half the thickness, in diameters

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= textureSize(surfaceLooks)) return;
    uint end = texelFetch(surfaceFanStarts, vertex + 1).x;
    vec3 normal = vec3(0.0);
    float thickness = 2.0 * frame.radius * texelFetch(surfaceLooks, vertex).z;
    for (uint k = texelFetch(surfaceFanStarts, vertex).x; k < end; ++k) {
        int first = 3 * int(texelFetch(surfaceFans, int(k)).x);
        ivec3 corner = ivec3(texelFetch(surfaceIndices, first).x, texelFetch(surfaceIndices, first + 1).x,
                             texelFetch(surfaceIndices, first + 2).x);
        vec3 a = texelFetch(surfacePlaces, corner.x).xyz;
        normal += cross(texelFetch(surfacePlaces, corner.y).xyz - a, texelFetch(surfacePlaces, corner.z).xyz - a);
        if (corner.x == corner.y) thickness = 0.0;
    }
    float size = length(normal);
    normals[vertex] = vec4(size > 0.0 ? normal / size : vec3(0.0, 1.0, 0.0), thickness);
}
