// One thread puts a vertex of a soft body's surface where its particles take it: sum of weight times place.
#include "render/common/frame.glsl"
#include "shared/matter_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(location = 0) uniform uint firstVertex;
layout(std430) writeonly buffer SurfacePlaces { vec4 places[]; };
uniform usamplerBuffer softVertices;        // vertex of its hull, first particle of its body
uniform usamplerBuffer softLinks;           // SOFT_LINKS a vertex of a hull: particle within its body, weight
uniform samplerBuffer positions;

void main()
{
    int vertex = int(gl_GlobalInvocationID.x);
    if (vertex >= textureSize(softVertices)) return;
    uvec2 which = texelFetch(softVertices, vertex).xy;
    vec3 place = vec3(0.0);
    for (int k = 0; k < SOFT_LINKS; ++k) {
        uvec2 link = texelFetch(softLinks, SOFT_LINKS * int(which.x) + k).xy;
        place += uintBitsToFloat(link.y) * texelFetch(positions, int(which.y + link.x)).xyz;
    }
    places[firstVertex + uint(vertex)] = vec4(place, 0.0);
}
