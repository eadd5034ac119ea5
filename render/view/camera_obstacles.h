#pragma once

#include "render/view/framed_sets.h"
#include "sim/gpu/buffer_table.h"
#include "sim/gpu/filled_buffer.h"

namespace knuckle {

/// What holds off cameras that move by themselves, on the device.
struct CameraObstacles {
    explicit CameraObstacles(const World& world) : CameraObstacles(cameraPlanes(world), cameraSolids(world)) {}

    /// Adds "cameraPlanes", "cameraSolids" and "cameraGrids".
    void addTo(BufferTable& table) { table.add(Lifetime::Constant, planes, solids, grids); }
    uint32_t planeCount() const { return static_cast<uint32_t>(planes.size()); }
    uint32_t solidCount() const { return static_cast<uint32_t>(solids.size()); }

    Buffer<gpu::vec4> planes;
    Buffer<gpu::CameraSolid> solids;
    Buffer<float> grids;

private:
    CameraObstacles(const std::vector<gpu::vec4>& planesOf, const CameraSolids& of)
        : planes(filledBuffer("cameraPlanes", planesOf)), solids(filledBuffer("cameraSolids", of.solids)),
          grids(filledBuffer("cameraGrids", of.grids))
    {
    }
};

}  // namespace knuckle
