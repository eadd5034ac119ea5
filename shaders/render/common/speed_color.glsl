// The colour of a speed.

// Slow to fast: deep blue, teal, green, amber, and near-white heat. Linear RGB.
vec3 speedColor(float share)
{
    const vec3 LIMITS[5] = vec3[5](vec3(0.020, 0.050, 0.230), vec3(0.010, 0.240, 0.360), vec3(0.120, 0.480, 0.160),
                                  vec3(0.900, 0.420, 0.040), vec3(1.000, 0.850, 0.640));
    float place = clamp(share, 0.0, 1.0) * 4.0;
    int below = min(int(place), 3);
    return mix(LIMITS[below], LIMITS[below + 1], place - float(below));
}
