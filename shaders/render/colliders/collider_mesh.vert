// A corner of a mesh or a heightfield that stands in the way.
#include "render/common/frame_blocks.glsl"

uniform samplerBuffer meshCorners;          // two a corner, world space: place, with the mesh; normal
uniform samplerBuffer meshColors;

out vec3 viewPlace;
out vec3 viewNormal;
flat out vec3 color;

void main()
{
    vec4 placed = texelFetch(meshCorners, 2 * gl_VertexID);
    vec3 place = placed.xyz;
    viewPlace = toView(place);
    viewNormal = directionToView(texelFetch(meshCorners, 2 * gl_VertexID + 1).xyz);
    color = texelFetch(meshColors, int(placed.w)).rgb;
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
}
