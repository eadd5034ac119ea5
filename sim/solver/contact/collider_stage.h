#pragma once

#include "sim/solver/stage.h"

namespace knuckle {

/// Colliders, then drains of fluids, then regions of releases. It has no kernels: contacts, fluids and releases read
/// it, and AnimationStage moves the colliders that clips move.
class ColliderStage : public Stage {
public:
    /// @throws DeviceError when the device's limits are too small for the grids of meshes and heightfields.
    explicit ColliderStage(const StageSetup&) {}
    void upload(const StageSetup& setup) override;
    void addBuffers(BufferTable& table) override;

    Buffer<gpu::Collider> colliders;   ///< Colliders, drains, regions of releases.
    Buffer<gpu::vec4> colliderPlaces;  ///< Of each its position [m] and orientation.
    Buffer<float> gridValues;          ///< Of all ColliderGrids, one after another.
    Buffer<gpu::vec4> colliderMoves;   ///< Per collider, if any moves: how far its place and its farthest point move in
                                       ///< the substep [m]; its turn.
    Buffer<float> colliderAheads;      ///< The same: how far its farthest point moves in the step [m].
};

}  // namespace knuckle
