#include "sim/solver/fluid/fluid_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "sim/solver/fluid/fluid_lattice.h"

namespace knuckle {

namespace {

constexpr uint32_t FIRST_NEIGHBOURS = 64;
/// Radius of the smoothing kernel [rest distances]. Below 2.2 the sums depend so much on the particles' arrangement
/// that water under pressure rubs like sand; above 2.5 the multipliers overshoot.
constexpr float FLUID_REACH = 2.2f;
/// A sum over a lattice divided by the same sum over fluid at rest, whose particles are less regular.
constexpr double DISORDER = 1.01;

/// Sums over a cubic lattice of Wendland's kernel without its constant, and of the squares of its slope: the density
/// and the denominator of lambda for the lattice that fluids start in.
struct LatticeSums {
    LatticeSums(double spacing, double reach)
    {
        const int cells = static_cast<int>(reach / spacing) + 1;
        for (int z = -cells; z <= cells; ++z)
            for (int y = -cells; y <= cells; ++y)
                for (int x = -cells; x <= cells; ++x) {
                    const double q = spacing * std::sqrt(double(x * x + y * y + z * z)) / reach, a = 1.0 - q;
                    if (a <= 0.0) continue;
                    density += std::pow(a, 4) * (1.0 + 4.0 * q);
                    slopes += std::pow(20.0 / reach * q * a * a * a, 2);
                    spread += std::pow(a, 4) * (1.0 + 4.0 * q) * reach * reach * q * q;
                }
    }
    double density = 0.0, slopes = 0.0, spread = 0.0;
};

/// The share of the kernel behind a plane at z, as in sim/fluid/fluid.glsl.
double wallFraction(double z, double reach)
{
    const double t = std::clamp(1.0 - z / reach, 0.0, 1.0);
    return std::pow(t, 6) * (3.5 - 4.5 * t + 1.5 * t * t);
}

/// Factor by which the listed particles of a layer must cover more for a fluid particle next to it, because both the
/// list and solidFraction() of sim/fluid/fluid.glsl fade out before the kernel ends. With 0.88 of that, bodies float as
/// deep as their density says.
float solidCover(const gpu::StepParameters& p)
{
    constexpr double CALIBRATION = 0.88;
    constexpr int SAMPLES = 400;
    const double d = p.diameter, nearest = 0.5 * (d + p.fluidSpacing), end = p.fluidListReach;
    double listed = 0.0, share = wallFraction(nearest - 0.5 * d, p.fluidReach);
    for (int k = 0; k < SAMPLES; ++k) {
        const double from = nearest + (end - nearest) * k / SAMPLES, to = nearest + (end - nearest) * (k + 1) / SAMPLES;
        const double u = std::clamp((end - 0.5 * (from + to)) / (0.2 * d), 0.0, 1.0), fade = u * u * (3.0 - 2.0 * u);
        listed += fade * (wallFraction(from - 0.5 * d, p.fluidReach) - wallFraction(to - 0.5 * d, p.fluidReach));
    }
    return static_cast<float>(CALIBRATION * share / listed);
}

void setLattice(gpu::StepParameters& p, const World& world)
{
    if (p.fluidCount == 0) return;
    const uint32_t cells = 2 * std::bit_ceil(std::max(p.particleCount + p.fluidCount, 4096u));
    const FluidLattice lattice = fluidLattice(world, p.fluidListReach, cells);
    p.fluidCellMask = cells - 1;
    p.fluidStrideY = lattice.strideY;
    p.fluidStrideZ = lattice.strideZ;
}

}  // namespace

void setFluidParameters(gpu::StepParameters& p, const World& world)
{
    p.fluidCount = world.fluidCount;
    p.fluidSlots = FIRST_NEIGHBOURS;
    p.fluidSpacing = world.fluidSpacing;
    p.fluidReach = FLUID_REACH * world.fluidSpacing;
    // Neighbours stay listed for a step; one that comes nearer meanwhile hardly counts yet. Solids reach a radius
    // beyond their centres.
    p.fluidListReach = std::max(p.fluidReach, 1.1f * world.diameter());
    p.solidCover = solidCover(p);
    p.inverseFluidCell = 1.0f / p.fluidListReach;
    setLattice(p, world);
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    p.fluidVolume = static_cast<float>(DISORDER / lattice.density);
    p.fluidSoftness = static_cast<float>(0.01 * lattice.slopes / (lattice.density * lattice.density));
}

// LEAST keeps resting fluids quiet; explicit steps are stable below 1.
float smoothing(const gpu::StepParameters& p, const Material& material, float time)
{
    constexpr double LEAST = 0.03, MOST = 0.9;
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    const double kinematic = material.viscosity / material.density;
    return static_cast<float>(std::clamp(6.0 * kinematic * time * lattice.density / lattice.spread, LEAST, MOST));
}

// A pair force f(r) at the number density n gives the surface tension pi n^2 / 8 times the integral of f r^4 (Fowler
// 1937; Rowlinson and Widom 1982, eq. 4.99) if positions are independent; fluidAttraction's is 0.0074777 reach^5. In a
// fluid they are not: measurements on puddles give 1 / CORRELATION of that.
float tension(const gpu::StepParameters& p, const Material& material)
{
    constexpr double CORRELATION = 1.26;
    const double density = std::pow(p.fluidSpacing, -3.0), reach = std::pow(double(p.fluidReach), 5);
    const double unit = std::numbers::pi / 8.0 * density * density * 0.0074777 * reach;
    const double force = CORRELATION * material.surfaceTension / unit;
    return static_cast<float>(force * p.substepTime * p.substepTime);
}

}  // namespace knuckle
