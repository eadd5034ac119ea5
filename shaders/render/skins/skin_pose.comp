// A group of threads poses one of a wearer's groups of vertices: linear blend skinning, sum w (c + R (v - c at rest)).
#include "math/quaternion.glsl"
#include "render/common/surface.glsl"
#include "shared/draw_types.h"
#include "shared/frame_types.h"

layout(local_size_x = RENDER_GROUP_SIZE) in;
layout(std430) readonly buffer SkinWearers { SkinWearer wearers[]; };
layout(std430) readonly buffer SkinPlaceCounts { uint placeCounts[]; };
layout(std430) readonly buffer SkinGroups { uvec4 groups[]; };      // as in skin.vert
layout(std430) readonly buffer SkinVertices { SkinVertex vertices[]; };
layout(std430) writeonly buffer SkinPlaces { uvec4 places[]; };     // place [m] and normal
uniform samplerBuffer skinCentres;          // per body, its mass centre at rest
uniform samplerBuffer bodyCentres;
uniform samplerBuffer bodyRotations;

uvec4 posed(SkinVertex vertex, uint firstBody)
{
    vec3 rest = vec3(vertex.placeX, vertex.placeY, vertex.placeZ);
    vec3 restNormal = vec3(unpackSnorm2x16(vertex.normalXY), unpackSnorm2x16(vertex.normalZWeight3).x);
    uvec4 bodies = uvec4(vertex.bodies01 & 0xFFFFu, vertex.bodies01 >> 16, vertex.bodies23 & 0xFFFFu,
                         vertex.bodies23 >> 16);
    vec4 weights = vec4(0.0, unpackUnorm2x16(vertex.weights12), unpackUnorm2x16(vertex.normalZWeight3).y);
    weights.x = 1.0 - weights.y - weights.z - weights.w;
    vec3 place = vec3(0.0), normal = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        if (weights[i] <= 0.0) continue;
        int body = int(firstBody + bodies[i]);
        vec4 rotation = texelFetch(bodyRotations, body);
        vec3 arm = rest - texelFetch(skinCentres, body).xyz;
        place += weights[i] * (texelFetch(bodyCentres, body).xyz + rotate(rotation, arm));
        normal += weights[i] * rotate(rotation, restNormal);
    }
    return uvec4(floatBitsToUint(place), packNormal(normal));
}

void main()
{
    uvec4 group = groups[gl_WorkGroupID.x];
    uint firstBody = wearers[group.x].firstBody;
    uint count = min(SKIN_GROUP_SIZE, max(placeCounts[group.x], group.z) - group.z);
    for (uint i = gl_LocalInvocationID.x; i < count; i += RENDER_GROUP_SIZE)
        places[SKIN_GROUP_SIZE * gl_WorkGroupID.x + i] = posed(vertices[group.y + i], firstBody);
}
