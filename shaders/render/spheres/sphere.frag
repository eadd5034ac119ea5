// The sphere's nearest point on the pixel's ray: its depth, normal and colour.
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#include "render/spheres/sphere_hit.glsl"
#include "render/common/rays/sphere_ray.glsl"
#include "math/quaternion.glsl"
#ifdef PATTERNS
#include "render/common/finish_pattern.glsl"

flat in vec4 placeInBody;
flat in vec4 bodyTurn;
flat in uint patternSeed;
#endif
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
    vec3 ray = pixelRay();
    SphereHit hit;
#ifdef GRAINS
    bool isHit = grainRadii.w == 1.0 ? grainHit(sphere.xyz, ray, hit)
                                     : sphereHit(sphere.xyz, radius, ray, hit);
#else
    bool isHit = sphereHit(sphere.xyz, radius, ray, hit);
#endif
    if (!isHit) discard;
    uint word = floatBitsToUint(sphere.w);
#ifdef PATTERNS
    vec3 arm = rotate(conjugate(bodyTurn), directionToWorld(hit.normal));
    vec3 place = alongAxis(placeInBody.xyz + arm, int(placeInBody.w));
    word = patternedWord(word, place, patternSeed, pixelWidth(hit.depth, hit.normal / radius));
#endif
    surface = uvec2(packNormal(hit.normal), word);
    gl_FragDepth = hit.depth * perFarDepth;
    SHOW_THING(THING_PARTICLE);
}
