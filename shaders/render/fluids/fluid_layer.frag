// LAYERS: the smoothed surface of fluid, as a surface like all others.
#include "render/common/surface.glsl"
#include "render/fluids/surface_slope.glsl"
#include "shared/thing_types.h"

uniform usampler2D fluidThingPicture;   // colour word, particle
layout(location = 0) out uvec2 surface;
layout(location = 1) out uvec2 thing;
layout(location = 2) out vec4 earlier;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(fluidWidePicture, pixel, 0).r, crease = 0.0, turned = 0.0;
    if (depth >= frame.farDepth) discard;
    uvec2 front = texelFetch(fluidThingPicture, pixel, 0).rg;
    surface = uvec2(packNormal(surfaceNormal(pixel, viewRay(gl_FragCoord.xy) * depth, crease, turned)), front.x);
    thing = uvec2(THING_PARTICLE, front.y);
    earlier = vec4(0.0);
    gl_FragDepth = depth / frame.farDepth;
}
