// Chebyshev's iterations in their form of three terms: an impulse changes by x (wanted - it) + y (its last change).

/// A body of few iterations takes them spread over those of the one with most. @param iteration of `all`.
bool isDue(uint iteration, uint all, uint own)
{
    return iteration == 0u || iteration * own / all != (iteration - 1u) * own / all;
}

/// x and y. The largest eigenvalue is 1 + steepness; the smallest is 1, of which the smallest root leaves nothing, if
/// that overshoots little enough.
/// @param iteration of the body's own, from 0 on.
vec2 chebyshevFactors(SoftMatter matter, float iteration, float steepness)
{
    float most = 1.0 + steepness, exact = (2.0 - most * (1.0 - matter.rootCosine)) / (1.0 + matter.rootCosine);
    float least = max(exact, matter.leastEigenvalue * most), middle = 0.5 * (least + most);
    if (iteration == 0.0) return vec2(1.0 / middle, 0.0);
    float ratio = (most - least) / (most + least);
    float t = ratio / (1.0 + sqrt(1.0 - ratio * ratio)), square = t * t, power = pow(square, iteration);
    float omega = (1.0 + square) * (1.0 + power) / (1.0 + power * square);
    return vec2(omega / middle, omega - 1.0);
}
