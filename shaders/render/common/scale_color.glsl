// The colour of a quantity: a place on a palette.

// Where the quantity is on its scale, 0 at its low end, 1 at its high one.
float shareOf(float value)
{
#ifdef COLOR_LOW
    value -= COLOR_LOW;
#endif
    return value / frame.speedScale;
}

#ifdef PALETTE
// Square roots of light, between which the eye sees even steps.
vec3 scaleColor(float value)
{
    const vec3 ROOTS[PALETTE_SIZE] = PALETTE;
    float place = clamp(shareOf(value), 0.0, 1.0) * float(PALETTE_SIZE - 1);
    int below = min(int(place), PALETTE_SIZE - 2);
    vec3 root = mix(ROOTS[below], ROOTS[below + 1], place - float(below));
    return root * root;
}
#else
// Slow to fast: deep blue, teal, green, amber, and near-white heat. Linear RGB.
vec3 scaleColor(float value)
{
    const vec3 LIMITS[5] = vec3[5](vec3(0.020, 0.050, 0.230), vec3(0.010, 0.240, 0.360), vec3(0.120, 0.480, 0.160),
                                  vec3(0.900, 0.420, 0.040), vec3(1.000, 0.850, 0.640));
    float place = clamp(shareOf(value), 0.0, 1.0) * 4.0;
    int below = min(int(place), 3);
    return mix(LIMITS[below], LIMITS[below + 1], place - float(below));
}
#endif

#ifdef COLOR_BY_QUANTITY
uniform samplerBuffer shownQuantities;   // per particle; NO_QUANTITY of those that have none

vec3 quantityColor(int particle)
{
    float value = texelFetch(shownQuantities, particle).x;
    return value == NO_QUANTITY ? vec3(NO_QUANTITY_GREY) : scaleColor(value);
}
#endif
