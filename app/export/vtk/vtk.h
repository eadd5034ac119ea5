#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "app/export/folder_export.h"

namespace knuckle {

/// Writes frame_0001.vtp and so on into a folder, and frames.pvd, which names them with their times [s]: VTK PolyData
/// of the particles that are there, a vertex each, with id, body (-1: none), material, velocity [m/s], radius [m] and
/// density [kg/m3]. Arrays are 32 bits, base64 in place.
class VtkExport : public FolderExport {
public:
    explicit VtkExport(std::string path) : FolderExport(std::move(path), ".vtp") {}
    ExportNeeds needs() const override { return {.particles = true, .densities = true}; }
    void addPaths(const Scene& scene, RunPaths& paths) const override;
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override;

private:
    std::string series() const { return path() + "/frames.pvd"; }

    double framesPerSecond_ = 60.0;
    std::vector<uint64_t> frames_;  ///< Written so far.
};

}  // namespace knuckle
