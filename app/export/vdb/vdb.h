#pragma once

#include "app/export/folder_export.h"

namespace knuckle {

/// Writes frame_0001.vdb and so on into a folder: OpenVDB points "particles" with "id" and "velocity" [m/s] and, of
/// fluids, the level set "fluid" [m]. Only where the program was built with OpenVDB.
class VdbExport : public FolderExport {
public:
    explicit VdbExport(std::string path) : FolderExport(std::move(path), ".vdb") {}
    ExportNeeds needs() const override { return {.particles = true}; }
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
};

}  // namespace knuckle
