// One point per particle in the light's view.
#include "render/common/fluid_kind.glsl"
#include "render/common/drawn_radius.glsl"

#ifndef SHADOW_TEXELS
#define SHADOW_TEXELS frame.shadowSize
#endif

uniform usamplerBuffer sphereList;
uniform samplerBuffer positions;

void main()
{
    uint particle = texelFetch(sphereList, gl_VertexID).x;
    gl_Position = vec4(worldToLight(texelFetch(positions, int(particle)).xyz), 1.0);
    if (isLeftOut(particle)) gl_Position = NOWHERE;
    gl_PointSize = drawnRadius(particle) / view.lightCentre.w * SHADOW_TEXELS;
}
