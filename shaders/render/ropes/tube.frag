// Depth, normal and colour of a rope of twisted strands.
#include "render/common/bump.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"

in vec3 viewNormal;
in vec3 viewPlace;
in vec3 colorRoots;
in float strandAngle;
layout(location = 0) out uvec2 surface;

/// Height of the strands over the grooves between them, in radii, and how much darker these are.
const float STRAND_HEIGHT = 0.35, GROOVE_SHADE = 0.45;

void main()
{
    vec2 change = vec2(dFdx(strandAngle), dFdy(strandAngle));
    // Fades where a strand comes near a pixel in size.
    float seen = 1.0 - smoothstep(1.2, 3.0, length(change));
    float height = abs(cos(0.5 * strandAngle));
    float slope = -0.5 * sin(0.5 * strandAngle) * sign(cos(0.5 * strandAngle)) * seen;
    vec3 normal = bumped(normalize(viewNormal), viewPlace, STRAND_HEIGHT * frame.radius * slope * change);
    float groove = (1.0 - height) * (1.0 - height);
    // Faded, they are as dark as they were in the mean, 3/2 - 4/pi.
    vec3 roots = colorRoots * (1.0 - GROOVE_SHADE * mix(0.227, groove, seen));
    surface = uvec2(packNormal(normal), packRoots(roots, 1.0));
    gl_FragDepth = 1.0 / (gl_FragCoord.w * frame.farDepth);
    SHOW_THING(THING_PARTICLE);
}
