// One point per particle in the light's view.
#include "render/common/sphere_sizes.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position;

void main()
{
    gl_Position = vec4(worldToLight(position), 1.0);
    gl_PointSize = sphereRadius(uint(gl_VertexID)) / view.lightCentre.w * frame.shadowSize;
}
