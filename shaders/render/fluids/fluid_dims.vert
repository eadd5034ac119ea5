// One point per DIMS_STRIDE particles in the light's view: what fluid dims of it.
#include "render/common/fluid_kind.glsl"
#include "render/common/drawn_radius.glsl"
#include "render/common/fluid_looks.glsl"

uniform samplerBuffer positions;
flat out vec4 dims;   // of the light through its middle, see fluid_dims.frag

/// As in fluid_tint.vert.
const float SPREAD = 1.3;
/// What is scattered goes on at a slant, half of it forwards.
const float SCATTERED = 0.5;

void main()
{
    uint particle = frame.solidCount + uint(gl_VertexID) * DIMS_STRIDE;
    vec4 position = texelFetch(positions, int(particle));
    float texel = 2.0 * view.lightCentre.w / DIMS_TEXELS, spacing = frame.fluidRadius / SURFACE_RADIUS;
    float radius = max(SPREAD * pow(float(DIMS_STRIDE), 1.0 / 3.0) * drawnRadius(particle), texel);
    uint material = texelFetch(fluidMaterials, int(particle - frame.solidCount)).x;
    FluidLook look = fetchFluidLook(material);
    // The frag's profile over a disc adds up to the space of these particles.
    float chord = float(DIMS_STRIDE) * spacing * spacing * spacing * 3.0 / (3.14159 * radius * radius);
    dims = vec4(look.absorption + SCATTERED * look.scattering, 1.0) * chord;
    bool seen = !isLeftOut(particle) && isThere(position);
    gl_Position = seen ? vec4(worldToLight(position.xyz), 1.0) : NOWHERE;
    gl_PointSize = 2.0 * radius / texel;
}
