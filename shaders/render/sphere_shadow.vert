// One point per particle in the light's view.
#include "shared/frame_blocks.glsl"

layout(location = POSITION_ATTRIBUTE) in vec3 position;

void main()
{
    gl_Position = vec4(worldToLight(position), 1.0);
    gl_PointSize = frame.radius / view.lightCentre.w * frame.shadowSize;
}
