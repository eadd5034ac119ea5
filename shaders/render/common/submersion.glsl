// Whether the camera is in fluid.

uniform usamplerBuffer submersion;   // how many particles are near it: submersion_count.comp

// In fluid at rest 14 are within 1.5 rest distances of a place, at its surface half as many.
const uint SUBMERSION_LEAST = 8u;

bool isUnderWater()
{
    return texelFetch(submersion, 0).x >= SUBMERSION_LEAST;
}
