#pragma once

#include "app/export/exporter.h"
#include "render/output/frame_names.h"

namespace knuckle {

/// Writes frame_0001.ply and so on into a folder: binary PLY with id, position [m], velocity [m/s], body (-1: none) and
/// material (index; its comments have their names), of all particles except inactive fluid ones: ids may have gaps.
class PlyExport : public Exporter {
public:
    using Exporter::Exporter;
    ExportNeeds needs() const override { return {.particles = true}; }
    void addPaths(const Scene& scene, RunPaths& paths) const override;
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override {}

private:
    FrameNames names() const { return {.folder = path(), .after = ".ply"}; }
};

}  // namespace knuckle
