// One point per listed particle, as large as the sphere's image, which is an ellipse.
#include "render/common/fluid_kind.glsl"
#include "render/common/drawn_radius.glsl"
#include "render/common/thing_out.glsl"
#include "render/spheres/fluid_form.glsl"
#include "render/common/sphere_bounds.glsl"
#include "render/spheres/sphere_color.glsl"
#include "render/common/rays/sphere_ray_out.glsl"
#ifdef PATTERNS
#include "render/spheres/sphere_place.glsl"
#endif
#ifdef GRAINS
#include "render/spheres/grain_look.glsl"
#endif

uniform usamplerBuffer sphereList;
uniform samplerBuffer positions;

flat out vec4 sphere;   // view-space centre, colour word
flat out float radius;

void main()
{
    int particle = int(texelFetch(sphereList, gl_VertexID).x);
    vec3 place = texelFetch(positions, particle).xyz, centre = toView(place);
    radius = drawnRadius(uint(particle));
    uint color = sphereColor(particle);
#ifdef GRAINS
    radius *= lookOfGrain(uint(particle), place, radius, color);
#endif
    float bound = radius * giveForm(uint(particle));
    float aspect = float(frame.width) / float(frame.height);
    vec4 bounds = sphereBounds(centre, bound, vec2(1.0 / aspect, 1.0) / frame.tanHalfFov);
    vec2 size = 0.5 * (bounds.zw - bounds.xy) * vec2(frame.width, frame.height);
    sphere = vec4(centre, uintBitsToFloat(color));
    gl_PointSize = max(size.x, size.y) + 1.0;
    gl_Position = vec4(0.5 * (bounds.xy + bounds.zw), 2.0 * (-centre.z - bound) / frame.farDepth - 1.0, 1.0);
    giveRays();
    NAME_THING(particle);
#ifdef PATTERNS
    placeSphere(particle);
#endif
    if (isLeftOut(uint(particle))) gl_Position = NOWHERE;
}
