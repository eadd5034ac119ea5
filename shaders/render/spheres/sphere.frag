// The sphere's nearest point on the pixel's ray: its depth, normal and colour.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"

flat in vec4 sphere;
flat in float radius;
layout(location = 0) out uvec2 surface;
// Points and quads have the sphere's nearest depth: hidden ones can be skipped before this runs.
layout(depth_greater) out float gl_FragDepth;

void main()
{
    vec3 ray = viewRay(gl_FragCoord.xy);
    float inverse = 1.0 / dot(ray, ray);
    // From the ray's nearest point to the centre: unlike the usual discriminant, this loses no digits far away.
    float along = dot(sphere.xyz, ray) * inverse;
    vec3 miss = sphere.xyz - along * ray;
    float h = radius * radius - dot(miss, miss);
    if (h < 0.0) discard;
    float depth = along - sqrt(h * inverse);
    surface = uvec2(packNormal((depth * ray - sphere.xyz) / radius), floatBitsToUint(sphere.w));
    gl_FragDepth = depth / frame.farDepth;
}
