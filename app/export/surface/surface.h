#pragma once

#include "app/export/folder_export.h"
#include "app/export/surface/surface_mesh.h"

namespace knuckle {

/// The fluid particles that are there. @param view of a state.
std::vector<FluidDrop> dropsOf(const World& world, const ViewState& view);

/// Writes frame_0001.ply and so on into a folder: the surface of all fluids as a closed mesh, binary PLY with places
/// [m], normals and triangles.
class SurfaceExport : public FolderExport {
public:
    explicit SurfaceExport(std::string path) : FolderExport(std::move(path), ".ply") {}
    ExportNeeds needs() const override { return {.particles = true}; }
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
};

}  // namespace knuckle
