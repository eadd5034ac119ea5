// The smoothing kernel of fluids: Wendland's C2, W(q) = 21 / (2 pi h^3) (1 - q)^4 (1 + 4 q), q = r / h, times the volume
// of a particle at rest, so that its sum over the lattice that fluids are filled with is 1.

float fluidShare(float q)
{
    float a = 1.0 - q, b = a * a;
    return step.fluidVolume * b * b * (1.0 + 4.0 * q);
}

/// d fluidShare / dr over r [1/m2]: the gradient is this times the vector.
float fluidSlope(float q)
{
    float a = 1.0 - q;
    return -20.0 * step.fluidVolume / (step.fluidReach * step.fluidReach) * a * a * a;
}

/// The attraction between particles of one fluid; its sums over the fluid make surface tension.
float fluidPull(float q)
{
    return max((q - 0.5) * (1.0 - q), 0.0);
}

/// The share of the kernel that lies behind a plane at the distance z, and its slope [1/m]: the integral of W over the
/// half space, 7/2 T^6 - 9/2 T^7 + 3/2 T^8 with T = 1 - z / h.
vec2 wallShare(float z)
{
    float t = clamp(1.0 - z / step.fluidReach, 0.0, 1.0);
    float t2 = t * t, t4 = t2 * t2;
    return vec2(t4 * t2 * (3.5 - 4.5 * t + 1.5 * t2), -(t4 * t) / step.fluidReach * (21.0 - 31.5 * t + 12.0 * t2));
}

/// How much a solid particle counts for a fluid one at that distance.
float solidWeight(float far)
{
    float a = max(1.0 - far / step.fluidListReach, 0.0);
    return a * a;
}
