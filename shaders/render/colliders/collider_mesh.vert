// A corner of a mesh or a heightfield that stands in the way.
#include "render/common/frame_blocks.glsl"

layout(location = 0) in vec3 place;         // world space
layout(location = 1) in vec3 normal;

out vec3 viewPlace;
out vec3 viewNormal;

void main()
{
    viewPlace = toView(place);
    viewNormal = directionToView(normal);
#ifdef LIGHT_VIEW
    gl_Position = vec4(worldToLight(place), 1.0);
#else
    gl_Position = projectView(viewPlace);
#endif
}
