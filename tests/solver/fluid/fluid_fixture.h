#pragma once

#include <bit>

#include "tests/solver/solver_test.h"

namespace knuckle::test {

/// A float of which only the upper half of its bits is kept (shaders/math/upper_halves.glsl).
inline float upperHalf(float v)
{
    return std::bit_cast<float>((std::bit_cast<uint32_t>(v) + 0x8000u) & 0xffff0000u);
}

/// A block, a plate, loose particles and water and oil, 1033 particles in all (no multiple of any group size), mixed at
/// random on both sides of the origin, on average as dense as water at rest; a plane below and one at the side. Lists
/// have room for all neighbours. The inputs of kernels are written from here, so that each is tested by itself;
/// "neighbours" are found by brute force.
class FluidFixture : public KernelFixture {
public:
    explicit FluidFixture(const Settings& settings = {});

    const gpu::StepParameters& parameters() const { return stages.parameters; }
    uint32_t count() const { return static_cast<uint32_t>(world.particles.size()); }
    uint32_t solidCount() const { return parameters().particleCount; }
    bool isFluid(uint32_t particle) const { return particle >= solidCount(); }
    Vector3d place(uint32_t particle) const { return vec3(places[particle]).cast<double>(); }
    double mass(uint32_t particle) const { return 1.0 / masses[particle].x; }

    /// Gives every particle a slot and every slot its neighbours, as the step does.
    void findNeighbours();
    /// Sets how the fluids' grid is wrapped: wide enough for its contents, or so early that distant particles look near
    /// to each other. To be called before findNeighbours().
    void wrap(bool early);
    /// Moves everything; to be called before findNeighbours().
    void setPlaces(const std::vector<gpu::vec4>& positions);
    /// Runs a kernel on all slots.
    void forSlots(const std::string& name, const Defines& defines = {}) { run(name, count(), defines); }
    /// Values of particles in the order of slots, and back.
    template <typename T>
    std::vector<T> inSlots(const std::vector<T>& values) const
    {
        std::vector<T> sorted(values.size());
        for (uint32_t k = 0; k < values.size(); ++k) sorted[k] = values[slotParticles[k]];
        return sorted;
    }
    template <typename T>
    std::vector<T> byParticle(const std::vector<T>& sorted) const
    {
        std::vector<T> values(sorted.size());
        for (uint32_t k = 0; k < sorted.size(); ++k) values[slotParticles[k]] = sorted[k];
        return values;
    }
    /// Entry n of a slot's list, sim/fluid/fluid_slots.glsl implemented anew.
    uint32_t entry(uint32_t slot, uint32_t n) const;
    /// Other particles of one kind that are nearer than `reach` [m].
    std::vector<uint32_t> near(uint32_t particle, bool fluid, double reach) const;
    /// Fluid particles that its kernel reaches.
    std::vector<uint32_t> fluidNear(uint32_t particle) const { return near(particle, true, parameters().fluidReach); }

    /// W times a particle's volume at the distance r, and its derivative by r [1/m]: sim/fluid/fluid.glsl implemented
    /// anew.
    double share(double r) const;
    double slope(double r) const
    {
        return derivative([&](double x) { return share(x); }, r);
    }
    /// By a central difference, so that the reference does not repeat the shaders' formulas.
    template <typename Function>
    static double derivative(const Function& function, double x)
    {
        constexpr double STEP = 1e-6;
        return (function(x + STEP) - function(x - STEP)) / (2.0 * STEP);
    }

    /// How a solid particle's cell is turned, as two whole numbers (sim/fluid/walls/solid_cells.glsl).
    gpu::vec4 packedTurn(uint32_t particle) const;

    std::vector<gpu::vec4> places, masses;
    std::vector<Quaternionf> turns;  ///< Of solid particles, as exact as they are packed.
    std::vector<uint32_t> slotParticles;
    std::vector<gpu::uvec2> slotCounts;
    std::vector<uint32_t> neighbours;  ///< slotNeighbours, one by one.
};

}  // namespace knuckle::test
