// Two triangles around the image of each listed sphere that is too large for the driver's points.
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
    uint particle = texelFetch(sphereList, gl_VertexID / QUAD_CORNERS).x;
    vec3 where = texelFetch(positions, int(particle)).xyz, centre = toView(where);
    radius = drawnRadius(particle);
    uint color = sphereColor(int(particle));
#ifdef GRAINS
    radius *= lookOfGrain(particle, where, radius, color);
#endif
    float bound = radius * giveForm(particle);
    float aspect = float(frame.width) / float(frame.height);
    vec4 bounds = sphereBounds(centre, bound, vec2(1.0 / aspect, 1.0) / frame.tanHalfFov);
    float nearest = max(-centre.z - bound, 0.0);
    sphere = vec4(centre, uintBitsToFloat(color));
    const int CORNERS[QUAD_CORNERS] = int[QUAD_CORNERS](0, 1, 2, 2, 1, 3);
    int place = CORNERS[gl_VertexID % QUAD_CORNERS];
    vec2 corner = vec2(place & 1, place >> 1);
    gl_Position = vec4(clamp(mix(bounds.xy, bounds.zw, corner), -1.0, 1.0),
                       2.0 * nearest / frame.farDepth - 1.0, 1.0);
    giveRays();
    NAME_THING(particle);
#ifdef PATTERNS
    placeSphere(int(particle));
#endif
    if (isLeftOut(particle)) gl_Position = NOWHERE;
}
