#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Static colliders, and behind them the drains of fluids and the regions of releases. It has no kernels: contacts,
/// fluids and releases read it.
class ColliderStage : public Stage {
public:
    /// @throws DeviceError when the device's limits are too small for the grids of meshes and heightfields.
    explicit ColliderStage(const StageSetup&) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    Buffer<gpu::GpuCollider> colliders;  ///< Static colliders, drains, regions of releases.
    Buffer<float> gridValues;            ///< Of all ColliderGrids, one after another.
};

}  // namespace knuckle
