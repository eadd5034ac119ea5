// The smoothing kernel of fluids: Wendland's C2, W(q) = 21 / (2 pi h^3) (1 - q)^4 (1 + 4 q), q = r / h, times the
// volume of a particle at rest, so that its sum over a fluid at rest is 1.
#include "shared/fluid_constants.h"

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

/// How far a plane that covers a fraction of the kernel is away, within a hundredth of the reach [m].
float wallDistance(float fraction)
{
    return sim.fluidReach * (1.0 - min(pow(max(2.0 * fraction, 0.0), 0.27), 1.0));
}

/// In a narrow gap, the kernels of fluid there reach through to the other side. What it gives each side then lacks this
/// factor. @param one,other  What the sides cover.
float gapGain(float one, float other)
{
    float t = clamp(1.0 - (wallDistance(one) + wallDistance(other)) / sim.fluidReach, 0.0, 1.0), t2 = t * t;
    return 1.0 / max(1.0 - 2.0 * t2 * t2 * t2 * (3.5 - 4.5 * t + 1.5 * t2), 0.25);
}

/// The weight of a solid particle at the distance r for a fluid one, when several solid particles share the force on it
/// or the direction out of them.
float solidWeight(float r)
{
    float a = max(1.0 - r / sim.fluidListReach, 0.0);
    return a * a;
}
