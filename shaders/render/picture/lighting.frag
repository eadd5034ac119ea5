// Lights the surfaces and paints the sky behind them; writes final colours, or light.
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/rays/screen_march.glsl"
#include "render/common/surface.glsl"
#include "render/common/sky.glsl"
#include "render/common/tone/tone_map.glsl"
#include "render/picture/backdrop.glsl"
#include "render/picture/lit_surface.glsl"

uniform usampler2D surfacePicture;
layout(location = 0) out vec4 picture;
#ifdef TRANSPARENT
layout(location = 1) out float cover;
#endif

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    vec3 ray = viewRay(gl_FragCoord.xy);
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
#ifdef VEIL
    if (depth >= frame.farDepth || isGround(surface)) discard;
#endif
    vec3 lit = litSurface(pixel, ray * depth, surface, depth);
    vec3 sky = backdrop(ray);
    float far = depth * length(ray) / frame.groundFade;
    float haze = isGround(surface) ? far * far / (1.0 + far * far) : 0.0;
    vec3 radiance = depth >= frame.farDepth ? sky : mix(lit, backdropHaze(ray, lit), haze);
#ifdef FOG
    bool isNothing = depth >= frame.farDepth;
    radiance = mix(frame.fog.rgb, radiance, clearShare(ray, isNothing ? FAR_AWAY : depth * length(ray)));
#endif
    vec3 color = written(radiance * frame.groundColor.w);
#ifdef TRANSPARENT
    cover = depth >= frame.farDepth ? 0.0 : 1.0 - haze;
    color *= cover;
#endif
    // The edge filter compares lightness, as the eye sees it.
    picture = vec4(color, lightness(color));
#ifdef TRANSPARENT
    // Where nothing is, is darker than anything.
    picture.a = cover * (0.25 + 0.75 * picture.a);
#endif
}
