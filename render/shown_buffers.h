#pragma once

#include "sim/gpu/buffer_table.h"
#include "sim/solver/particle_view.h"
#include "sim/world/world.h"

namespace knuckle {

/// The solver's buffers of a view in the renderer's table, which does not own them.
class ShownBuffers {
public:
    explicit ShownBuffers(const World& world);

    void addTo(BufferTable& table);
    /// Before each frame.
    void attach(const ParticleView& view);
    uint32_t foamCount() const { return foamCount_; }

private:
    RawBuffer positions_, velocities_, bodyCentres_, bodyRotations_, colliderPlaces_, foamPlaces_, fluidForms_,
        distanceStates_;
    uint32_t foamCount_ = 0;
    Buffer<uint32_t> balls_;            ///< Where a view has no forms.
    Buffer<gpu::vec4> wholeDistances_;  ///< Where a view has no distances.
};

}  // namespace knuckle
