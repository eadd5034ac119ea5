// Light through glass of a convex shape. The includer defines before this how a ray meets the shape, in the shape's own
// axes: float hitFrom(vec3 origin, vec3 way, out vec3 normal).
#include "render/common/fog.glsl"
#include "render/common/rays/mirrored.glsl"
#include "render/common/sky.glsl"

layout(location = 0) out vec4 picture;

const float GLASS_INDEX = 1.5;
const float GLASS_REFLECTION = 0.04;   // of light that falls straight on it
const float GLASS_GLINT = 1500.0;      // sharpness of the sun's image
const int BOUNCES = 4;

/// A ray that has gone through the shape: where it leaves it, which way, and how far it went inside [m].
struct Passage {
    vec3 exit, way;
    float inside;
};

/// In the shape's axes; light that is thrown back inside (corners of boxes) goes on.
/// @param way  Of unit length. @param size  More than the shape's size [m].
Passage passGlass(vec3 entry, vec3 way, vec3 normal, float size)
{
    Passage ray = Passage(entry, refract(way, normal, 1.0 / GLASS_INDEX), 0.0);
    for (int k = 0; k < BOUNCES; ++k) {
        vec3 other;
        float back = hitFrom(ray.exit + size * ray.way, -ray.way, other);
        other = normalize(other);
        float along = back > 0.0 ? max(size - back, 0.0) : 0.0;
        ray.exit += along * ray.way;
        ray.inside += along;
        vec3 outside = refract(ray.way, -other, GLASS_INDEX);
        if (back <= 0.0 || dot(outside, outside) > 0.0) {
            ray.way = back > 0.0 ? outside : way;
            break;
        }
        ray.way = reflect(ray.way, other);
    }
    return ray;
}

/// In view space. @param color  What is left of white light that has gone through the shape's thickness.
/// @param thick  How often it has.
vec4 glassPicture(vec3 p, vec3 normal, Passage ray, vec3 color, float thick)
{
    vec3 toEye = -normalize(p), mirror = reflect(-toEye, normal);
    float rest = 1.0 - max(dot(normal, toEye), 0.0), rest2 = rest * rest;
    float share = GLASS_REFLECTION + (1.0 - GLASS_REFLECTION) * rest2 * rest2 * rest;
    vec3 through = lightAlong(ray.exit, ray.way, skyTowards(ray.way)) * pow(max(color, 1e-3), vec3(min(thick, 4.0)));
    vec3 around = lightAlong(p + 0.002 * -p.z * normal, mirror, skyTowards(mirror));
    float glint = pow(max(dot(mirror, view.keyInView.xyz), 0.0), GLASS_GLINT);
    vec3 light = mix(through, around, share) + 2.0 * glint * frame.keyColor.rgb;
#ifdef FOG
    light = mix(frame.fog.rgb, light, clearShare(p, length(p)));
#endif
    vec3 shown = written(light * frame.groundColor.w);
    return vec4(shown, lightness(shown));
}

/// Whether something stands before it, or it is not its turn.
bool isHidden(float depth)
{
    float before = texelFetch(depthPicture, ivec2(gl_FragCoord.xy), 0).r * frame.farDepth;
    return depth >= before || isOtherSide(depth);
}
