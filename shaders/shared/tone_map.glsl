// Scene-linear light to display values.

// Rational fit of the ACES reference rendering (K. Narkowicz, "ACES Filmic Tone Mapping Curve", 2016).
vec3 filmicCurve(vec3 x)
{
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 x)
{
    vec3 high = 1.055 * pow(max(x, vec3(1e-6)), vec3(1.0 / 2.4)) - 0.055;
    return mix(high, 12.92 * x, lessThanEqual(x, vec3(0.0031308)));
}
