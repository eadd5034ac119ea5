// A vertex of a wearer's skin, at its place from skin_pose.comp.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing_out.glsl"
#include "shared/draw_types.h"

uniform usamplerBuffer skinPlaces;          // place [m] and normal
uniform usamplerBuffer skinGroups;          // wearer, its first vertex, number of earlier ones; its finish
uniform samplerBuffer skinVertexLooks;      // uv, colour, material

out vec3 viewNormal;
out vec2 uv;
out vec3 colorRoots;            // of the colour, so that pixels need not compute them
flat out int material;
#ifdef FINISHES
flat out uint finishAlpha;
#endif
#ifdef LAYERS
uniform usamplerBuffer earlierSkinPlaces;
uniform usamplerBuffer skinWearers;
uniform usamplerBuffer skinVertices;

// The body of the wearer that moves a vertex most.
uint mainBody(uint wearer, uint vertex)
{
    uvec4 words = texelFetch(skinVertices, int(2u * vertex + 1u));
    uvec4 bodies = uvec4(words.x & 0xffffu, words.x >> 16, words.y & 0xffffu, words.y >> 16);
    vec4 weights = vec4(0.0, unpackUnorm2x16(words.z), unpackUnorm2x16(words.w).y);
    weights.x = 1.0 - weights.y - weights.z - weights.w;
    uint most = 0u;
    for (uint i = 1u; i < 4u; ++i)
        if (weights[i] > weights[most]) most = i;
    return texelFetch(skinWearers, int(2u * wearer)).x + bodies[most];
}
#endif

void main()
{
    uvec4 posed = texelFetch(skinPlaces, gl_VertexID);
    uvec4 group = texelFetch(skinGroups, gl_VertexID / int(SKIN_GROUP_SIZE));
    uint firstVertex = group.y;
    vec4 looks = texelFetch(skinVertexLooks, int(firstVertex) + gl_VertexID % int(SKIN_GROUP_SIZE));
    vec3 place = uintBitsToFloat(posed.xyz);
    viewNormal = directionToView(unpackNormal(posed.w));
    uv = looks.xy;
    colorRoots = unpackRoots(uint(looks.z));
    material = int(looks.w);
#ifdef FINISHES
    // Of the wearer, or of the model's material.
    finishAlpha = group.w != 0u ? group.w : uint(material) >> 16;
    material &= 0xffff;
#endif
#ifdef LAYERS
    earlierPlace = uintBitsToFloat(texelFetch(earlierSkinPlaces, gl_VertexID).xyz);
    NAME_THING(mainBody(group.x, firstVertex + uint(gl_VertexID) % SKIN_GROUP_SIZE));
#endif
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(toView(place));
#endif
}
