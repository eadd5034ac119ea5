#pragma once

#include "tests/solver/solver_test.h"

namespace knuckle::test {

/// Two bodies, loose particles, 137 fluid particles without an emitter, and three emitters: one of wide layers, one
/// that reuses its oldest particles, and one that stops. No pool is a multiple of a chunk of the lists (SCAN_CHUNK).
/// Two drains and, before them in the same list, two colliders.
class EmitterFixture : public KernelFixture {
public:
    EmitterFixture();

    EmitterStage& stage() { return *stages.emitters; }
    uint32_t emitterCount() const { return static_cast<uint32_t>(world.emitters.size()); }
    const Emitter& emitter(uint32_t k) const { return world.emitters[k]; }
    uint32_t pointCount(uint32_t k) const { return static_cast<uint32_t>(emitter(k).nozzle.points.size()); }
    uint32_t poolStart(uint32_t k) const { return emitters_[k].poolStart; }
    uint32_t poolCapacity() const { return stages.parameters.poolCapacity; }
    uint32_t solidCount() const { return stages.parameters.particleCount; }
    double step() const { return world.settings.timeStep; }
    /// Runs sim/emitter/<name> as in a world with pools.
    void runPools(const std::string& name, uint64_t threads, const Defines& more = {});

    /// Sets the number of steps done at the end of the current one, which decides the half of the list that it reads.
    void setSteps(uint32_t steps);
    uint32_t before() const { return (steps_ & 1) * poolCapacity(); }
    uint32_t after() const { return poolCapacity() - before(); }
    /// Shuffles each pool's list, each half by itself.
    void shuffle(uint32_t seed);
    /// Makes some particles of the pools inactive, `share` of them at random, and sums them as a step does.
    void deactivate(float share, uint32_t seed);
    uint32_t inactiveOf(uint32_t k) const;
    /// Sets how many particles came and left until now.
    void setTotals(uint32_t came, uint32_t left);
    std::vector<uint32_t> totals() { return stage().fluidTotals.download(); }
    void setStates(const std::vector<gpu::EmitterState>& states) { fill(stage().emitterStates, states); }

    std::vector<uint32_t> order;     ///< poolOrder, both halves.
    std::vector<uint32_t> inactive;  ///< poolInactive, by place in the list.
    std::vector<gpu::vec4> positions, velocities;

private:
    std::vector<gpu::Emitter> emitters_;
    uint32_t steps_ = 0;
};

}  // namespace knuckle::test
