// The smoothing kernel of fluids: Wendland's C2, W(q) = 21 / (2 pi h^3) (1 - q)^4 (1 + 4 q), q = r / h, times the
// volume of a particle at rest, so that its sum over a fluid at rest is 1.

/// Where a fluid particle is at the end of the substep if no pressure acts [m].
vec3 predictedPosition(vec3 x, vec3 v)
{
    return x + sim.substepTime * (v + sim.substepTime * sim.gravity.xyz);
}

/// The kernel over its height in the middle, a = 1 - q.
float fluidShape(float a)
{
    float b = a * a;
    return b * b * (5.0 - 4.0 * a);
}

float fluidFraction(float q)
{
    return sim.fluidVolume * fluidShape(1.0 - q);
}

/// d fluidFraction / dr over r [1/m2], over a^3: the gradient is this times a^3 times the vector.
float fluidSteepness()
{
    return -20.0 * sim.fluidVolume / (sim.fluidReach * sim.fluidReach);
}

/// d fluidFraction / dr over r [1/m2].
float fluidSlope(float q)
{
    float a = 1.0 - q;
    return fluidSteepness() * a * a * a;
}

/// How strongly particles of one fluid attract each other. The sums over the fluid make its surface tension.
float fluidAttraction(float q)
{
    return max((q - 0.5) * (1.0 - q), 0.0);
}

/// The fraction of the kernel that lies behind a plane at the distance z and a little more (FLUID_WALL_GAP), and its
/// slope [1/m]: the integral of W over the half space, 7/2 T^6 - 9/2 T^7 + 3/2 T^8 with T = 1 - z / h.
vec2 wallFraction(float z)
{
    float t = clamp(1.0 - (z + FLUID_WALL_GAP * sim.fluidSpacing) / sim.fluidReach, 0.0, 1.0);
    float t2 = t * t, t4 = t2 * t2;
    return vec2(t4 * t2 * (3.5 - 4.5 * t + 1.5 * t2), -(t4 * t) / sim.fluidReach * (21.0 - 31.5 * t + 12.0 * t2));
}

/// The fraction of the kernel that a solid particle of diameter d at the distance r covers, and its slope over r
/// [1/m2]. A layer of such particles, a diameter apart, covers on average as much as a half space that ends a radius
/// from their centres: 2 pi / d^2 times the integral of this times r from z + d / 2 on is wallFraction(z). So every
/// particle displaces the volume of its cell, at faces and edges, in plates and alone.
vec2 solidFraction(float r, float d)
{
    float bounded = max(r, 0.25 * d), inverse = 1.0 / sim.fluidReach;
    float gap = FLUID_SOLID_GAP * sim.fluidSpacing;
    float t = clamp(1.0 - (bounded - 0.5 * d + gap) * inverse, 0.0, 1.0), t2 = t * t, t4 = t2 * t2;
    float slope = t4 * t * inverse * (21.0 - 31.5 * t + 12.0 * t2);
    float bend = t4 * inverse * inverse * (105.0 - 189.0 * t + 84.0 * t2);
    float scale = sim.solidCover * d * d / (6.2831853 * bounded);
    vec2 covered = scale * vec2(slope, -(bend + slope / bounded) / bounded);
    // Lists of neighbours end before the kernel does, so the fraction fades out smoothly there.
    float width = 0.2 * d, u = clamp((sim.fluidListReach - r) / width, 0.0, 1.0), fade = u * u * (3.0 - 2.0 * u);
    float steep = u > 0.0 && u < 1.0 ? -6.0 * u * (1.0 - u) / width : 0.0;
    return vec2(covered.x * fade, covered.y * fade + covered.x * steep / bounded);
}

/// The weight of a solid particle at the distance r for a fluid one, when several solid particles share the force on it
/// or the direction out of them.
float solidWeight(float r)
{
    float a = max(1.0 - r / sim.fluidListReach, 0.0);
    return a * a;
}
