#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Colliders, and behind them the drains of fluids and the regions of releases. It has no kernels: contacts, fluids and
/// releases read it, and AnimationStage writes where colliders are that clips move.
class ColliderStage : public Stage {
public:
    /// @throws DeviceError when the device's limits are too small for the grids of meshes and heightfields.
    explicit ColliderStage(const StageSetup&) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    Buffer<gpu::Collider> colliders;   ///< Colliders, drains, regions of releases.
    Buffer<gpu::vec4> colliderPlaces;  ///< Of each its position [m] and orientation.
    Buffer<float> gridValues;          ///< Of all ColliderGrids, one after another.
    Buffer<gpu::vec4> colliderMoves;   ///< Per collider, where any moves: how far its place and its farthest point
                                       ///< come in the substep [m]; its turn.
    Buffer<float> colliderAheads;      ///< The same: how far its farthest point comes in the step [m].
};

}  // namespace knuckle
