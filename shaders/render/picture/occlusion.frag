// Half resolution: how much of the ambient light and of the key light reaches the surface.
#include "render/common/frame_blocks.glsl"
#include "render/common/surface.glsl"
#include "render/picture/shade.glsl"
#include "render/picture/soft_shadow.glsl"
#include "render/picture/taps.glsl"

uniform sampler2D depthPicture;
uniform usampler2D surfacePicture;
layout(location = 0) out uint shade;

const int OCCLUSION_TAPS = 5;
const float MAX_OCCLUSION_PIXELS = 110.0;

// Ambient obscurance (McGuire et al. 2011, "The Alchemy Screen-Space Ambient Obscurance Algorithm", eq. 10, with the
// falloff of "Scalable Ambient Obscurance", 2012).
float ambientReach(ivec2 pixel, vec3 p, vec3 n, int k)
{
    float radius = frame.occlusionRadius;
    float pixels = min(radius * float(frame.height) / (2.0 * frame.tanHalfFov * -p.z), MAX_OCCLUSION_PIXELS);
    float sum = 0.0;
    vec2 direction = pixelDirection(k);
    for (int i = 0; i < OCCLUSION_TAPS; ++i) {
        vec2 unit = spiral(i, k, OCCLUSION_TAPS, direction);
        direction = turned(direction, GOLDEN_4);
        ivec2 tap = clamp(pixel + ivec2(unit * pixels), ivec2(0),
                          ivec2(frame.width, frame.height) - 1);
        vec3 v = viewRay(vec2(tap) + 0.5) * (texelFetch(depthPicture, tap, 0).r * frame.farDepth) - p;
        float square = dot(v, v);
        float fade = max(1.0 - square / (radius * radius), 0.0);
        sum += fade * fade * max(dot(v, n) - 0.002 * -p.z, 0.0) / (square + 0.01 * radius * radius) * radius;
    }
    return clamp(1.0 - 0.75 * sum / float(OCCLUSION_TAPS), 0.0, 1.0);
}

void main()
{
    ivec2 place = ivec2(gl_FragCoord.xy);
    ivec2 pixel = min(2 * place, ivec2(frame.width, frame.height) - 1);
    float depth = texelFetch(depthPicture, pixel, 0).r;
    if (depth >= 1.0) discard;
    vec3 p = viewRay(vec2(pixel) + 0.5) * (depth * frame.farDepth);
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
    if (isGround(surface) && isOpen(viewToLight(p))) discard;
    vec3 n = unpackNormal(surface.x);
    int k = (place.x & 1) + 2 * (place.y & 1);
    float key = dot(n, view.keyInView.xyz) > 0.0 ? keyReach(p, n, k) : 0.0;
    shade = packShade(depth * frame.farDepth, ambientReach(pixel, p, n, k), key, !isGround(surface));
}
