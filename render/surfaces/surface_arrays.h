#pragma once

#include <cstdint>
#include <vector>

#include "render/surfaces/sheet_edges.h"
#include "shared/matter_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// What a renderer has on the device of the surfaces of cloth and of soft bodies, before it is uploaded. Vertices and
/// triangles of cloth come first.
struct SurfaceArrays {
    /// @param colors words of packColor(), per particle. What is not seen is left out.
    SurfaceArrays(const World& world, const std::vector<uint32_t>& colors);

    std::vector<Triangle> triangles;
    std::vector<uint32_t> cells;      ///< Per triangle of cloth.
    std::vector<gpu::vec4> looks;     ///< Per vertex: threads across and along, half the thickness, colour.
    std::vector<uint32_t> particles;  ///< Per vertex, the nearest one.
    std::vector<gpu::ClothSheet> sheets;
    std::vector<gpu::uvec4> clothVertices;
    std::vector<uint32_t> clothNodes;
    std::vector<gpu::uvec4> clothCells;  ///< The distances at their sides, or NEVER_TORN.
    std::vector<gpu::uvec4> hemEdges;
    std::vector<gpu::uvec2> softVertices, softLinks;

private:
    void addGrid(const ClothSurface& sheet, uint32_t steps, float color);
    void addMesh(const ClothSurface& sheet, float color);
    void addCells(const World& world);
    void addSoft(const World& world, const SoftSurface& surface, uint32_t firstVertex, float color);

    std::vector<std::vector<uint32_t>> cellCorners_;  ///< Particles around each cell of cloth.
};

}  // namespace knuckle
