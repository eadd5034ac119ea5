// One point per particle in the light's view.
#include "render/spheres/drawn_radius.glsl"

uniform usamplerBuffer sphereList;
uniform samplerBuffer positions;

void main()
{
    uint particle = texelFetch(sphereList, gl_VertexID).x;
    gl_Position = vec4(worldToLight(texelFetch(positions, int(particle)).xyz), 1.0);
    gl_PointSize = drawnRadius(particle) / view.lightCentre.w * frame.shadowSize;
}
