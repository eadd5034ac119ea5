// The depth of the nearest fluid.
#include "render/common/sphere_hit.glsl"

flat in vec4 sphere;
flat in float radius;
// As in sphere.frag.
layout(depth_greater) out float gl_FragDepth;

void main()
{
    SphereHit hit;
    if (!sphereHit(sphere.xyz, radius, gl_FragCoord.xy, hit)) discard;
    gl_FragDepth = hit.depth / frame.farDepth;
}
