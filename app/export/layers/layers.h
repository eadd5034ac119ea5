#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/export/exporter.h"
#include "app/export/layers/layer_film.h"
#include "render/stored_view.h"

namespace knuckle {

/// Writes pictures as data into a folder: an EXR file a frame with depth, normals, albedo, ids and motion of what each
/// pixel shows, camera.json and annotations.json. Of each camera but the scene's own shots in a folder of its name
/// below.
class LayerExport : public Exporter {
public:
    using Exporter::Exporter;
    ExportNeeds needs() const override { return {.views = true}; }
    void setViews(const std::vector<FilmView>& views) override { views_ = views; }
    void addPaths(const Scene& scene, RunPaths& paths) const override;
    void begin(const Scene& scene) override;
    void open(Gpu& gpu) override;
    void pass(const ExportFrame& frame) override;
    void frame(const ExportFrame& frame) override;
    void finish() override;
    void close() override;

private:
    std::string folderOf(const FilmView& view) const;

    std::vector<FilmView> views_;
    const Scene* scene_ = nullptr;
    std::vector<Rig> rigs_;
    std::optional<SceneThings> things_;
    std::optional<StoredView> stored_;
    std::vector<std::unique_ptr<LayerFilm>> films_;
};

}  // namespace knuckle
