// Pair forces of viscosity: a pair exchanges impulses along the line between its particles, k r (r . dv), so they keep
// momentum and angular momentum, and what turns like a solid feels none.

/// k over the thickness, of two fluid particles at a squared distance.
float fluidShear(float squared, float inverseReach)
{
    float a = 1.0 - min(sqrt(squared) * inverseReach, 1.0);
    return a * a * a;
}

/// k over the grip, of a fluid particle and a solid one.
float solidShear(float squared)
{
    float a = 1.0 - min(sqrt(squared) / sim.fluidListReach, 1.0);
    return a * a;
}

/// Thickness between two fluids: the harmonic mean, as of layers in a row that the same stress shears.
float thicknessBetween(float one, float other)
{
    return 2.0 * one * other / max(one + other, 1e-30);
}

/// k of a particle and a fluid neighbour of it. @param fluid  Whether the particle is. @param grip  The neighbour's.
float pairStrength(bool fluid, float squared, float inverseReach, float own, float other, float grip)
{
    return fluid ? thicknessBetween(own, other) * fluidShear(squared, inverseReach) : grip * solidShear(squared);
}

/// What the half space behind a wall at the distance z would hold a particle with if it were fluid that moves in
/// proportion to its depth, from zero in the wall's surface on, or `slip` behind it; for a reach of 1: the integral of
/// a^3 x^2 n / (z + slip) over it, n being the depth below the particle and x along the wall [1/m].
float wallShear(float z, float slip)
{
    float t = min(z / sim.fluidReach, 1.0), a = 1.0 - t, a3 = a * a * a;
    return 3.1166e-4 * a3 * a3 * (5.0 + t * (30.0 + t * (69.0 + t * 64.0))) / (z + slip);
}
