#include "sim/solver/fluid/fluid_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>

#include "sim/solver/fluid/fluid_lattice.h"
#include "sim/solver/pack.h"

namespace knuckle {

namespace {

/// Room for neighbours at the start: among themselves fluids have some 45; beside solids, whose lists reach further, up
/// to 90.
constexpr uint32_t FIRST_NEIGHBOURS = 64, FIRST_NEIGHBOURS_WITH_SOLIDS = 96;
/// Radius of the smoothing kernel [rest distances]. Below 2.2 the sums depend much on the particles' arrangement; above
/// 2.5 the multipliers overshoot.
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
                    pulls += std::pow(a, 3) * std::pow(reach * q, 2);
                    density += std::pow(a, 4) * (1.0 + 4.0 * q);
                    slopes += std::pow(20.0 / reach * q * a * a * a, 2);
                    spread += std::pow(a, 4) * (1.0 + 4.0 * q) * reach * reach * q * q;
                }
    }
    double density = 0.0, slopes = 0.0, spread = 0.0;
    double pulls = 0.0;  ///< a^3 r^2, of viscous pairs.
};

/// Rates at which a thin fluid's particles lose what differs from an even change of velocity around them, and a viscous
/// fluid's at least lose the difference to their neighbours [1/s]. They keep resting fluids quiet.
constexpr double EVEN_SMOOTHING = 35.0, LEAST_VISCOUS_SMOOTHING = 1.8;
/// Explicit smoothing is stable below 1.
constexpr double MOST_SMOOTHING = 0.9;
/// At rest a fluid's particles move at a few times of what weight gives them in a substep, which pressures take back.
constexpr float QUIET = 6.0f;

/// Where v = y^2 / 2 along x, the forces k r (r . dv) of pairs add up to the sum of k r^4 / 30, which has to be the
/// viscosity times the volume of a particle; k is a^3 times this: impulse of a viscous pair over a^3 r^2 and the
/// difference of velocity [kg/m2].
float thicknessOf(const gpu::StepParameters& p, double viscosity)
{
    const double volume = std::pow(p.fluidSpacing, 3);
    const double shears = 4.0 * std::numbers::pi / 840.0 * std::pow(p.fluidReach, 7) / volume;
    return static_cast<float>(30.0 * volume * viscosity * p.substepTime / shears);
}

/// As in sim/fluid/viscous/viscous_pairs.glsl, times the distance, without slip.
double wallShear(double z, double reach)
{
    const double t = std::min(z / reach, 1.0);
    return std::numbers::pi / 10080.0 * std::pow(1.0 - t, 6) * (5.0 + t * (30.0 + t * (69.0 + t * 64.0)));
}

/// Integrals of pair forces over the solid grip: over a layer of solid particles, a diameter apart, that a fluid
/// particle is next to, and over a half space of fluid that a solid particle is next to.
struct SolidSums {
    explicit SolidSums(const gpu::StepParameters& p)
    {
        constexpr int SAMPLES = 400;
        const double nearest = 0.5 * (p.diameter + p.fluidSpacing), end = p.fluidListReach;
        const double step = (end - nearest) / SAMPLES;
        const double inLayer = std::pow(p.diameter, -2), inFluid = std::pow(p.fluidSpacing, -3);
        for (int k = 0; k < SAMPLES; ++k) {
            const double r = nearest + (k + 0.5) * step,
                         strength = step * std::numbers::pi * std::pow(1.0 - r / end, 2);
            along += inLayer * strength * r * (r * r - nearest * nearest);
            across += inLayer * strength * 2.0 * r * nearest * nearest;
            onSolid += inFluid * strength * 2.0 * std::pow(r, 4);
        }
    }
    double along = 0.0, across = 0.0;  ///< How the layer holds a fluid particle [m2].
    double onSolid = 0.0;              ///< The trace of how fluid holds a solid particle [m2].
};

/// How far solid particles are listed [m]: a fluid particle 1.3 spacings in front of a face lists the cells on all
/// sides of the spot below it, before they fade out. With less, faces are bumpy for fluids.
float solidReach(const gpu::StepParameters& p)
{
    const float d = p.diameter;
    return p.particleCount > 0 ? std::hypot(1.3f * p.fluidSpacing + 0.5f * d, std::sqrt(0.5f) * d) + 0.1f * d : 0.0f;
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
    p.fluidSlots = p.particleCount > 0 ? FIRST_NEIGHBOURS_WITH_SOLIDS : FIRST_NEIGHBOURS;
    p.fluidSpacing = world.fluidSpacing;
    p.fluidReach = FLUID_REACH * world.fluidSpacing;
    // Neighbours stay listed for a step; one that comes nearer meanwhile hardly counts yet.
    p.fluidListReach = std::max(p.fluidReach, solidReach(p));
    p.inverseFluidCell = 1.0f / p.fluidListReach;
    setLattice(p, world);
    const Settings& s = world.settings;
    p.evenSmoothing = static_cast<float>(std::min(EVEN_SMOOTHING * s.timeStep, MOST_SMOOTHING));
    setQuietSpeed(p);
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    p.fluidVolume = static_cast<float>(DISORDER / lattice.density);
    p.fluidSoftness = static_cast<float>(0.01 * lattice.slopes / (lattice.density * lattice.density));
}

void setQuietSpeed(gpu::StepParameters& p)
{
    p.quietSpeed = QUIET * std::max(vectorOf(p.gravity).norm(), 1.0f) * p.substepTime;
}

bool isViscous(const Material& material)
{
    return material.fluid && material.viscosity >= VISCOUS;
}

gpu::vec4 viscousMaterial(const gpu::StepParameters& p, const Material& material)
{
    if (!isViscous(material)) return {thicknessOf(p, material.viscosity * (material.fluid ? 1.0 : 0.0)), 0, 0, 0};
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    const double least = LEAST_VISCOUS_SMOOTHING * lattice.spread / (6.0 * lattice.density);
    const double viscosity = std::max<double>(material.viscosity, least * material.density);
    const float thickness = thicknessOf(p, viscosity);
    const double near = 0.5 * p.fluidSpacing, wall = std::pow(p.fluidReach, 6) * std::pow(p.fluidSpacing, -3);
    const double depth = near + material.slip - 0.2 * p.fluidSpacing;  // as viscous_start.comp has it of walls
    const double solid = wall * wallShear(near, p.fluidReach) / (depth * SolidSums(p).along);
    return {thickness, static_cast<float>(thickness * wall), static_cast<float>(thickness * solid), material.slip};
}

namespace {

/// [kg]; infinity if there is no solid particle
double lightestSolid(const World& world)
{
    double mass = std::numeric_limits<double>::infinity();
    for (const Particle& q : world.particles)
        if (!world.materials[q.material].fluid) mass = std::min(mass, double(q.mass));
    return mass;
}

/// About the largest eigenvalue of viscosity, as viscous_stiffness.comp bounds it: in the fluid, of fluid at solids, of
/// solids in it. Very light solids count as if they were heavier: sweeps must end.
double stiffness(const gpu::StepParameters& p, const World& world)
{
    constexpr double MOST_BY_SOLIDS = 25.0;
    const double volume = std::pow(p.fluidSpacing, 3), solid = lightestSolid(world);
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    const SolidSums solids(p);
    double stiffest = 0.0;
    for (const Material& m : world.materials) {
        if (!m.fluid) continue;
        const gpu::vec4 viscous = viscousMaterial(p, m);
        const double fluid = 2.0 * viscous.x * lattice.pulls / 3.0 / (m.density * volume);
        const double atSolids = 0.5 * fluid + 2.0 * viscous.z * solids.across / (m.density * volume);
        const double ofSolids = std::min(viscous.z * solids.onSolid / solid, MOST_BY_SOLIDS * fluid);
        stiffest = std::max({stiffest, fluid, std::isinf(solid) ? 0.0 : atSolids, ofSolids});
    }
    return stiffest;
}

}  // namespace

// Chebyshev's method of n sweeps leaves 2 exp(-2 n / sqrt(k)) of an error, k being the ratio of the largest to the
// smallest eigenvalue.
uint32_t viscousSweeps(const gpu::StepParameters& p, const World& world)
{
    constexpr double LEFT = 0.1, CROWDED = 1.3;
    const double largest = 1.0 + CROWDED * stiffness(p, world);
    return std::max(static_cast<uint32_t>(std::ceil(0.5 * std::sqrt(largest) * std::log(2.0 / LEFT))), 1u);
}

namespace {

// A pair force f(r) at the number density n gives the surface tension pi n^2 / 8 times the integral of f r^4 (Fowler
// 1937; Rowlinson and Widom 1982, eq. 4.99) if positions are independent; fluidAttraction's is 0.0074777 reach^5. In a
// fluid they are not: measurements on puddles give 1 / CORRELATION of that.
float tension(const gpu::StepParameters& p, const Material& material)
{
    constexpr double CORRELATION = 0.77;
    const double density = std::pow(p.fluidSpacing, -3.0), reach = std::pow(double(p.fluidReach), 5);
    const double unit = std::numbers::pi / 8.0 * density * density * 0.0074777 * reach;
    const double force = CORRELATION * material.surfaceTension / unit;
    return static_cast<float>(force * p.substepTime * p.substepTime);
}

}  // namespace

gpu::vec4 fluidMaterial(const gpu::StepParameters& p, const Material& material, float timeStep)
{
    if (isViscous(material)) return {-1, tension(p, material), 0, 0};
    const LatticeSums lattice(p.fluidSpacing, p.fluidReach);
    const double kinematic = material.viscosity / material.density;
    const double rate = 6.0 * kinematic * lattice.density / lattice.spread;
    return {static_cast<float>(std::min(rate * timeStep, MOST_SMOOTHING - p.evenSmoothing)), tension(p, material), 0,
            0};
}

float lambdaUnit(const gpu::StepParameters& parameters)
{
    return 1000.0f / 256.0f * std::pow(parameters.fluidSpacing, 3.0f) / (100.0f * parameters.fluidSoftness);
}

}  // namespace knuckle
