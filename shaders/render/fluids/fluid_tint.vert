// One point per fluid particle, at half resolution. What is behind things is left out.
#include "render/common/drawn_radius.glsl"
#include "render/common/sphere_bounds.glsl"
#include "render/common/fluid_kind.glsl"
#include "render/common/fluid_looks.glsl"

uniform samplerBuffer positions;
uniform sampler2D depthPicture;

#ifdef EMISSION
flat out vec4 emission;
#endif
flat out vec4 tint, glow;   // of the light through its middle, see fluid_tint.frag

/// Particles are spread wider than they are drawn, so that they do not show.
const float SPREAD = 1.3;

bool isInFront(vec4 bounds, float depth)
{
    vec2 size = vec2(frame.width, frame.height);
    ivec2 pixel = ivec2(clamp((0.25 * (bounds.xy + bounds.zw) + 0.5) * size, vec2(0.0), size - 1.0));
    return depth < texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
}

void main()
{
    uint i = frame.solidCount + gl_VertexID;
    vec4 position = texelFetch(positions, int(i));
    vec3 centre = toView(position.xyz);
    float radius = SPREAD * drawnRadius(i), aspect = float(frame.width) / float(frame.height);
    vec4 bounds = sphereBounds(centre, radius, vec2(1.0 / aspect, 1.0) / frame.tanHalfFov);
    vec2 size = 0.25 * (bounds.zw - bounds.xy) * vec2(frame.width, frame.height);
    uint material = texelFetch(fluidMaterials, gl_VertexID).x;
    FluidLook look = fetchFluidLook(material);
    // The frag's profile over a disc adds up to the space of a particle.
    float spacing = frame.fluidRadius / SURFACE_RADIUS;
    float chord = spacing * spacing * spacing * 3.0 / (3.14159 * radius * radius);
    tint = vec4(look.absorption, look.scattering) * chord;
    glow = vec4(look.color * look.scattering, 1.0) * chord;
#ifdef EMISSION
    float dimming = look.scattering + dot(look.absorption, vec3(1.0 / 3.0));
    emission = vec4(look.color * look.emission, 1.0) * (dimming * chord);
#endif
    bool seen = !isLeftOut(i) && isThere(position) && -centre.z > radius && isInFront(bounds, -centre.z);
    gl_PointSize = max(max(size.x, size.y), 1.0);
    gl_Position = seen ? vec4(0.5 * (bounds.xy + bounds.zw), 0.0, 1.0) : NOWHERE;
}
