// Polished ground over the lit picture: what the ray that it mirrors meets in the picture, else the sky.
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/rays/mirrored.glsl"
#include "render/common/sky.glsl"
#include "render/common/surface.glsl"
#include "render/common/tone/tone_map.glsl"

uniform usampler2D surfacePicture;
layout(location = 0) out vec4 picture;

const int STEPS = 56;
const float GROWTH = 1.1;
// Shares that are mirrored straight on and more of along the ground.
const float STRAIGHT = 0.22;
const float GRAZING = 0.70;

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
    if (depth >= frame.farDepth || !isGround(surface) || isOtherSide(depth)) discard;
    vec3 ray = viewRay(gl_FragCoord.xy), p = ray * depth, toEye = -normalize(p), n = unpackNormal(surface.x);
    vec3 way = reflect(-toEye, n), light = skyTowards(way);
    float along = met(p + 0.002 * -p.z * n, way, STEPS, GROWTH, ANY_THICKNESS);
    vec2 place = pictureOf(p + along * way);
    bool meetsGround = isGround(texelFetch(surfacePicture, ivec2(place * vec2(frame.width, frame.height)), 0).xy);
    if (along > 0.0 && (!meetsGround || showsFluid(place))) {
        vec3 seen = lightIn(textureLod(litPicture, place, 0.0).rgb) / frame.groundColor.w;
        light = mix(light, seen, knownShare(place));
    }
#ifdef FOG
    light = mix(frame.fog.rgb, light, clearShare(ray, depth * length(ray)));
#endif
    float rest = 1.0 - max(dot(n, toEye), 0.0), rest2 = rest * rest, far = depth * length(ray) / frame.groundFade;
    float share = (STRAIGHT + GRAZING * rest2 * rest2 * rest) / (1.0 + far * far);
    vec3 own = lightIn(texelFetch(litPicture, pixel, 0).rgb) / frame.groundColor.w;
    vec3 color = written(mix(own, light, share) * frame.groundColor.w);
    picture = vec4(color, lightness(color));
}
