// One point per particle in the light's view: what fluid dims of it.
#include "render/common/fluid_kind.glsl"
#include "render/common/drawn_radius.glsl"
#include "render/common/fluid_looks.glsl"

uniform usamplerBuffer sphereList;
uniform samplerBuffer positions;
flat out vec4 dims;   // of the light through its middle, see fluid_dims.frag

/// As in fluid_tint.vert.
const float SPREAD = 1.3;
/// What is scattered goes on at a slant, half of it forwards.
const float SCATTERED = 0.5;

void main()
{
    uint particle = texelFetch(sphereList, gl_VertexID).x;
    float texel = 2.0 * view.lightCentre.w / SHADOW_TEXELS, spacing = frame.fluidRadius / SURFACE_RADIUS;
    float radius = max(SPREAD * drawnRadius(particle), texel);
    uint material = texelFetch(fluidMaterials, int(particle - frame.solidCount)).x;
    FluidLook look = fetchFluidLook(material == NO_SURFACE ? 0u : material);
    // The frag's profile over a disc adds up to the space of a particle.
    float chord = spacing * spacing * spacing * 3.0 / (3.14159 * radius * radius);
    dims = vec4(look.absorption + SCATTERED * look.scattering, 1.0) * chord;
    gl_Position = vec4(worldToLight(texelFetch(positions, int(particle)).xyz), 1.0);
    if (isLeftOut(particle)) gl_Position = NOWHERE;
    gl_PointSize = 2.0 * radius / texel;
}
