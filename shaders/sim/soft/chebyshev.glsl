// Chebyshev's iteration for eigenvalues from `least` to `most`, in its form of three terms: an impulse changes by
// x (wanted - impulse) + y (last change).

/// @param iteration from 0 on.
vec2 chebyshevFactors(float iteration, float least, float most)
{
    float middle = 0.5 * (least + most);
    if (iteration < 0.5) return vec2(1.0 / middle, 0.0);
    float ratio = (most - least) / (most + least);
    float t = ratio / (1.0 + sqrt(1.0 - ratio * ratio)), square = t * t, power = pow(square, iteration);
    float omega = (1.0 + square) * (1.0 + power) / (1.0 + power * square);
    return vec2(omega / middle, omega - 1.0);
}
