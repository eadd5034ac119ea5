// Lights beside the key light, which cast no shadows.

uniform samplerBuffer lightSources;     // two each: place [m] or direction towards it, w: 1 for a point; colour

// @param light  Gets its colour times its strength there. @returns the direction towards it.
vec3 sourceWay(int index, vec3 p, out vec3 light)
{
    vec4 place = texelFetch(lightSources, 2 * index);
    light = texelFetch(lightSources, 2 * index + 1).rgb;
    vec3 way = place.w > 0.5 ? toView(place.xyz) - p : directionToView(place.xyz);
    float square = max(dot(way, way), 1e-6);
    if (place.w > 0.5) light /= square;
    return way * inversesqrt(square);
}
