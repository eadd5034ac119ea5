// The depth of the nearest fluid, whose particles are spheroids.
#include "render/common/rays/sphere_ray.glsl"
#ifdef LAYERS
flat in uint thingIndex;
layout(location = 0) out uvec2 frontThing;   // colour word, particle
#endif

flat in vec4 sphere;
flat in float radius;
flat in vec3 formAxis;
flat in vec2 formScales;
// As in sphere.frag.
layout(depth_greater) out float gl_FragDepth;

/// Space in which the spheroid is a ball.
vec3 rounded(vec3 v)
{
    return (v + formScales.x * dot(formAxis, v) * formAxis) * formScales.y;
}

void main()
{
    vec3 ray = rounded(pixelRay()), centre = rounded(sphere.xyz);
    float inverse = 1.0 / dot(ray, ray), along = dot(centre, ray) * inverse;
    vec3 miss = centre - along * ray;
    float h = radius * radius - dot(miss, miss);
    float depth = along - sqrt(max(h, 0.0) * inverse);
    // An eye inside, or beside it in front, sees through it.
    if (h < 0.0 || depth <= 0.0) discard;
#ifdef LAYERS
    frontThing = uvec2(floatBitsToUint(sphere.w), thingIndex);
#endif
    gl_FragDepth = depth * perFarDepth;
}
