// Lights beside the key light. They shade what the camera sees behind what it sees: by a ray through the depth picture.
#include "render/common/rays/screen_march.glsl"

uniform samplerBuffer lightSources;     // two each: place [m] or direction towards it, w: 1 for a point; colour

const int SHADOW_STEPS = 36;
const float SHADOW_GROWTH = 1.1;
// What is nearer to a point light shades nothing, as the lamp that it is in [particle radii].
const float LAMP = 12.0;
// What is seen is taken for so thick [particle radii].
const float THICK = 6.0;

// @param n  Normal there. @param light  Gets its colour times its strength there.
// @returns the direction towards it.
vec3 sourceWay(int index, vec3 p, vec3 n, out vec3 light)
{
    vec4 place = texelFetch(lightSources, 2 * index);
    light = texelFetch(lightSources, 2 * index + 1).rgb;
    vec3 way = place.w > 0.5 ? toView(place.xyz) - p : directionToView(place.xyz);
    float square = max(dot(way, way), 1e-6), far = place.w > 0.5 ? sqrt(square) - LAMP * frame.radius : 1e6;
    if (place.w > 0.5) light /= square;
    way *= inversesqrt(square);
    if (dot(n, way) <= 0.0) return way;
    float along = met(p + (0.3 * frame.radius + 0.002 * -p.z) * n, way, SHADOW_STEPS, SHADOW_GROWTH,
                      THICK * frame.radius);
    if (along > 0.0 && along < far) light = vec3(0.0);
    return way;
}
