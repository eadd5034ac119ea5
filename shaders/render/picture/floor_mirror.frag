// Polished ground over the lit picture: what the ray that it mirrors meets in the picture, else the sky. What the
// camera does not see, as the undersides of things, is not mirrored either: its front is, or the sky.
#include "render/common/fog.glsl"
#include "render/common/frame_blocks.glsl"
#include "render/common/sky.glsl"
#include "render/common/surface.glsl"
#include "render/common/tone_map.glsl"

uniform sampler2D litPicture;
uniform sampler2D depthPicture;
uniform usampler2D surfacePicture;
layout(location = 0) out vec4 picture;

const int STEPS = 56;
const float GROWTH = 1.1;           // of a step over the one before
const int HALVINGS = 6;
// Shares that are mirrored straight on and more of along the ground.
const float STRAIGHT = 0.22;
const float GRAZING = 0.70;

// How far behind what is in the picture a point is [m].
float behind(vec3 p)
{
    return -p.z - textureLod(depthPicture, pictureOf(p), 0.0).r * frame.farDepth;
}

bool isInside(vec2 place)
{
    return all(greaterThan(place, vec2(0.0))) && all(lessThan(place, vec2(1.0)));
}

/// @returns how far along the ray something is met, below 0 if nothing is.
float met(vec3 p, vec3 way)
{
    float from = 0.0, by = 0.4 * frame.radius + 0.002 * -p.z;
    for (int k = 0; k < STEPS; ++k) {
        float to = from + by;
        vec3 there = p + to * way;
        if (-there.z <= 0.0 || !isInside(pictureOf(there))) return -1.0;
        float gap = behind(there);
        if (gap > 0.0 && gap < 2.0 * by + 3.0 * frame.radius) {
            for (int h = 0; h < HALVINGS; ++h) {
                float middle = 0.5 * (from + to);
                if (behind(p + middle * way) > 0.0) to = middle;
                else from = middle;
            }
            return to;
        }
        from = to;
        by *= GROWTH;
    }
    return -1.0;
}

void main()
{
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float depth = texelFetch(depthPicture, pixel, 0).r * frame.farDepth;
    uvec2 surface = texelFetch(surfacePicture, pixel, 0).xy;
    if (depth >= frame.farDepth || !isGround(surface)) discard;
    vec3 ray = viewRay(gl_FragCoord.xy), p = ray * depth, toEye = -normalize(p), n = unpackNormal(surface.x);
    vec3 way = reflect(-toEye, n), light = skyTowards(way);
    float along = met(p + 0.002 * -p.z * n, way);
    vec2 place = pictureOf(p + along * way);
    if (along > 0.0 && !isGround(texelFetch(surfacePicture, ivec2(place * vec2(frame.width, frame.height)), 0).xy)) {
        vec3 seen = lightIn(textureLod(litPicture, place, 0.0).rgb) / frame.groundColor.w;
        vec2 edge = clamp(12.0 * min(place, 1.0 - place), 0.0, 1.0);
        light = mix(light, seen, edge.x * edge.y);
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
