// A vertex of a wearer's skin, at its place from skin_pose.comp.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "shared/draw_types.h"

uniform usamplerBuffer skinPlaces;          // place [m] and normal
uniform usamplerBuffer skinGroups;          // wearer, its first vertex, number of the wearer's earlier vertices
uniform samplerBuffer skinVertexLooks;      // uv, colour, material

out vec3 viewNormal;
out vec2 uv;
out vec3 colorRoots;            // of the colour, so that pixels need not compute them
flat out int material;

void main()
{
    uvec4 posed = texelFetch(skinPlaces, gl_VertexID);
    uint firstVertex = texelFetch(skinGroups, gl_VertexID / int(SKIN_GROUP_SIZE)).y;
    vec4 looks = texelFetch(skinVertexLooks, int(firstVertex) + gl_VertexID % int(SKIN_GROUP_SIZE));
    vec3 place = uintBitsToFloat(posed.xyz);
    viewNormal = directionToView(unpackNormal(posed.w));
    uv = looks.xy;
    colorRoots = unpackRoots(uint(looks.z));
    material = int(looks.w);
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(toView(place));
#endif
}
