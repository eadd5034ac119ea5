#pragma once

#include "app/export/folder_export.h"

namespace knuckle {

/// Writes frame_0001.bgeo and so on into a folder: Houdini's classic binary geometry, version 5, of the particles that
/// are there, with `v` [m/s], `id`, `body` (-1: none), `material`, `pscale` (radius) [m] and `density` [kg/m3].
class BgeoExport : public FolderExport {
public:
    explicit BgeoExport(std::string path) : FolderExport(std::move(path), ".bgeo") {}
    ExportNeeds needs() const override { return {.particles = true, .densities = true}; }
    void frame(const ExportFrame& frame) override;
};

}  // namespace knuckle
