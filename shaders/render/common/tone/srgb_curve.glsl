// The display's curve (IEC 61966-2-1), of 0 to 1.

vec3 toSrgb(vec3 light)
{
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, greaterThan(light, vec3(0.0031308)));
}

vec3 fromSrgb(vec3 shown)
{
    return mix(shown / 12.92, pow((shown + 0.055) / 1.055, vec3(2.4)), greaterThan(shown, vec3(0.04045)));
}
