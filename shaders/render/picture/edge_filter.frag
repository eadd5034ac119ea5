// Smooths stair steps: where neighbours differ, blends along the edge's direction. After the idea of fast approximate
// antialiasing (T. Lottes 2009): estimate the edge's tangent from the lightness of the diagonal neighbours.

uniform sampler2D litPicture;
layout(location = 0) out vec4 smoothed;
#ifdef TRANSPARENT
uniform sampler2D coverPicture;
layout(location = 1) out float smoothedCover;
#endif

const float MIN_CONTRAST = 0.035;
const float RELATIVE_CONTRAST = 0.10;
const float MAX_SPAN = 8.0;

void main()
{
    vec2 texel = 1.0 / vec2(textureSize(litPicture, 0));
    vec2 at = gl_FragCoord.xy * texel;
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(litPicture, 0) - 1;
    float here = texelFetch(litPicture, pixel, 0).a;
    float nw = texelFetch(litPicture, clamp(pixel + ivec2(-1, 1), ivec2(0), last), 0).a;
    float ne = texelFetch(litPicture, clamp(pixel + ivec2(1, 1), ivec2(0), last), 0).a;
    float sw = texelFetch(litPicture, clamp(pixel + ivec2(-1, -1), ivec2(0), last), 0).a;
    float se = texelFetch(litPicture, clamp(pixel + ivec2(1, -1), ivec2(0), last), 0).a;
    float low = min(here, min(min(nw, ne), min(sw, se)));
    float high = max(here, max(max(nw, ne), max(sw, se)));
    if (high - low < max(MIN_CONTRAST, RELATIVE_CONTRAST * high)) discard;

    vec2 gradient = vec2(ne + se - nw - sw, nw + ne - sw - se);
    vec2 tangent = vec2(-gradient.y, gradient.x);
    float shortest = min(abs(tangent.x), abs(tangent.y)) + 0.03 * (nw + ne + sw + se) * 0.25 + 1.0 / 128.0;
    tangent = clamp(tangent / shortest, -MAX_SPAN, MAX_SPAN) * texel;
    vec4 near = 0.5 * (textureLod(litPicture, at - tangent / 6.0, 0.0) +
                       textureLod(litPicture, at + tangent / 6.0, 0.0));
    vec4 far = 0.5 * near + 0.25 * (textureLod(litPicture, at - 0.5 * tangent, 0.0) +
                                    textureLod(litPicture, at + 0.5 * tangent, 0.0));
    // A long span that leaves the range of its neighbours has crossed another edge.
    smoothed = far.a < low || far.a > high ? near : far;
#ifdef TRANSPARENT
    float nearCover = 0.5 * (textureLod(coverPicture, at - tangent / 6.0, 0.0).r +
                             textureLod(coverPicture, at + tangent / 6.0, 0.0).r);
    float farCover = 0.5 * nearCover + 0.25 * (textureLod(coverPicture, at - 0.5 * tangent, 0.0).r +
                                               textureLod(coverPicture, at + 0.5 * tangent, 0.0).r);
    smoothedCover = far.a < low || far.a > high ? nearCover : farCover;
#endif
}
