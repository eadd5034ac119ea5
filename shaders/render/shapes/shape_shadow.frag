// The light's ray against a body's shape: its depth in the shadow map.
#include "render/common/frame_blocks.glsl"
#include "render/shapes/ray_rounded.glsl"

flat in vec4 rounded;
flat in vec4 source;
in vec4 boxPoint;

void main()
{
#ifdef GLASS
    // A quarter of the light is kept, which smooths out in the shadow.
    if (((int(gl_FragCoord.x) | int(gl_FragCoord.y)) & 1) != 0) discard;
#endif
    // Starts outside, towards the light.
    float reach = 2.0 * (length(rounded.xyz) + 2.0 * rounded.w);
    vec3 normal;
    float along = rayRounded(boxPoint.xyz + reach * source.xyz, -source.xyz, rounded.xyz, rounded.w, normal);
    if (along < 0.0) discard;
    float depth = boxPoint.w + (along - reach) / view.lightDepth.x;
    gl_FragDepth = clamp(0.5 * depth + 0.5, 0.0, 1.0);
}
