#pragma once

#include "render/settings.h"
#include "sim/gpu/kernel.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// What colours show of each particle, from the solver's own buffers: pressure and density of fluids, strain of soft
/// bodies; ages and forces of contacts are read as the solver has them. Speeds need no such pass.
class QuantityPass {
public:
    /// @param table must have "frame" and "positions"; gets "shownQuantities".
    QuantityPass(const Gpu& gpu, BufferTable& table, const World& world, const RenderSettings& settings);
    QuantityPass(const QuantityPass&) = delete;
    QuantityPass& operator=(const QuantityPass&) = delete;

    /// @throws RunError for a view that does not have the quantity.
    void attach(const ParticleView& view);
    void update(KernelTimer& timer) const;

private:
    void addSlots(BufferTable& table);
    void addClusters(BufferTable& table, const World& world);

    uint32_t particleCount_ = 0, clusterCount_ = 0;
    bool ofFluids_ = false, isPressure_ = false;
    ColorBy quantity_;
    Buffer<float> shown_;
    RawBuffer kept_;  ///< Stands in for the view's ages or forces of contacts.
    RawBuffer particleSlots_, slotParticles_, slotPressures_, slotShapes_, slotCovers_;  ///< Stand in for the view's.
    Buffer<gpu::uvec2> clusters_;                                                        ///< First link, end.
    Buffer<gpu::vec4> moments_, links_;     ///< As of quantity_cluster.comp.
    Buffer<uint32_t> linked_;               ///< Particles of links.
    Buffer<uint32_t> starts_, clustersOf_;  ///< Clusters of each particle.
    Buffer<float> strains_;
    Kernel fluid_, cluster_, soft_;
};

}  // namespace knuckle
