// Depth, normal and colour of cloth or of a soft body.
#include "render/common/bump.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/common/thing.glsl"
#include "render/surfaces/weave.glsl"
#include "shared/matter_types.h"

in vec3 viewNormal;
in vec3 viewPlace;
in vec3 colorRoots;
in vec3 weave;
layout(location = 0) out uvec2 surface;

void main()
{
    vec3 normal = normalize(viewNormal), roots = colorRoots;
    vec2 perX = dFdx(weave.xy), perY = dFdy(weave.xy);
    Weave at = weaveAt(weave.xy, perX, perY);
    if (weave.z == 1.0) {
        float thread = 2.0 * frame.radius / THREADS_A_CELL;
        normal = bumped(normal, viewPlace, thread * vec2(dot(at.slope, perX), dot(at.slope, perY)));
        roots *= at.shade;
    }
    surface = uvec2(packNormal(normal), packRoots(roots, 1.0));
    gl_FragDepth = 1.0 / (gl_FragCoord.w * frame.farDepth);
    SHOW_THING(THING_PARTICLE);
}
