#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/export/exporter.h"
#include "app/export/rig.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

/// The simulated motion as one clip of a binary glTF file: actors with their own skeletons, meshes and materials, other
/// bodies as nodes with their particles. Matter without bodies is left out.
class GltfExport : public Exporter {
public:
    /// @throws InputError for a path that ends in .gltf.
    explicit GltfExport(const std::string& path);
    ExportNeeds needs() const override { return {.surfaces = true, .bodies = true}; }
    /// "colliders", "fluids", ...
    std::vector<std::string> leftOut(const World& world) const override;
    /// @throws InputError also for a scene without bodies.
    void begin(const Scene& scene) override;
    void frame(const ExportFrame& frame) override;
    void finish() override;

private:
    double framesPerSecond_ = 0.0;
    std::vector<Rig> rigs_;
    std::optional<OutputFile> file_;
};

}  // namespace knuckle
