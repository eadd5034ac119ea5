// The sphere's nearest point on the pixel's ray: its depth, normal and colour.
#include "render/common/surface.glsl"
#include "render/common/sphere_hit.glsl"
#ifdef GRAINS
#include "render/spheres/grain_hit.glsl"
#endif

flat in vec4 sphere;
flat in float radius;
layout(location = 0) out uvec2 surface;
// Points and quads have the sphere's nearest depth: hidden ones can be skipped before this runs.
layout(depth_greater) out float gl_FragDepth;

void main()
{
    SphereHit hit;
#ifdef GRAINS
    bool isHit = grainRadii.w == 1.0 ? grainHit(sphere.xyz, gl_FragCoord.xy, hit)
                                     : sphereHit(sphere.xyz, radius, gl_FragCoord.xy, hit);
#else
    bool isHit = sphereHit(sphere.xyz, radius, gl_FragCoord.xy, hit);
#endif
    if (!isHit) discard;
    surface = uvec2(packNormal(hit.normal), floatBitsToUint(sphere.w));
    gl_FragDepth = hit.depth / frame.farDepth;
}
