#pragma once

#include "app/export/folder_export.h"

namespace knuckle {

/// Writes frame_0001.ply and so on into a folder: binary PLY with id, position [m], velocity [m/s], body (-1: none) and
/// material (index; its comments have their names), of all particles except inactive fluid ones: ids may have gaps.
class PlyExport : public FolderExport {
public:
    explicit PlyExport(std::string path) : FolderExport(std::move(path), ".ply") {}
    ExportNeeds needs() const override { return {.particles = true}; }
    void frame(const ExportFrame& frame) override;
};

}  // namespace knuckle
