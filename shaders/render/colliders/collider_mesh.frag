// Depth, normal and colour of a mesh, which is visible from both sides.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

in vec3 viewPlace;
in vec3 viewNormal;
flat in vec3 color;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 normal = normalize(viewNormal);
    surface = uvec2(packNormal(dot(normal, viewPlace) > 0.0 ? -normal : normal), packAlbedo(color, 1.0));
    gl_FragDepth = -viewPlace.z / frame.farDepth;
}
