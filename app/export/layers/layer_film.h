#pragma once

#include <optional>
#include <string>
#include <vector>

#include "app/export/exporter.h"
#include "app/export/layers/annotations.h"
#include "app/export/layers/pixel_motion.h"
#include "render/layers/layer_renderer.h"
#include "render/output/frame_names.h"

namespace knuckle {

/// What one camera's pictures as data are called.
struct LayerFiles {
    std::string folder;

    FrameNames frames() const { return {.folder = folder, .after = ".exr"}; }
    std::string camera() const { return folder + "/camera.json"; }
    std::string annotations() const { return folder + "/annotations.json"; }
};

/// The pictures as data that one camera of a run takes.
class LayerFilm {
public:
    /// @param scene, things, rigs must outlive it. @throws what LayerRenderer throws.
    LayerFilm(Gpu& gpu, const Scene& scene, const FilmView& view, LayerFiles files, const SceneThings& things,
              const std::vector<Rig>& rigs);

    /// A frame that is not written. @param drawn its state on the device.
    void pass(const ExportFrame& frame, const ParticleView& drawn);
    /// Writes its picture. @throws RunError.
    void frame(const ExportFrame& frame, const ParticleView& drawn);
    /// Writes what is of all frames.
    void finish();

private:
    size_t shotOf(uint64_t frame) const;
    /// Whether the frame before was of the same shot.
    bool goesOn(uint64_t frame) const;
    void addCamera(const ExportFrame& frame, const Layers& layers, const std::string& file);

    const Scene& scene_;
    const SceneThings& things_;
    std::vector<Shot> shots_;
    LayerFiles files_;
    LayerRenderer renderer_;
    Annotations annotations_;
    std::optional<SeenState> before_;  ///< The frame before.
    Json cameras_ = Json::array();
};

}  // namespace knuckle
