#include "app/export/layers/layers.h"

#include <algorithm>

#include "sim/base/files/output_file.h"

namespace knuckle {

std::string LayerExport::folderOf(const FilmView& view) const
{
    if (view.camera.empty()) return path();
    std::string name = view.camera;
    std::ranges::replace(name, '/', '_');
    return path() + "/" + (name.starts_with('.') ? "camera" + name : name);
}

void LayerExport::addPaths(const Scene& /*scene*/, RunPaths& paths) const
{
    for (const FilmView& view : views_) {
        const LayerFiles files{folderOf(view)};
        paths.writesFrames(files.frames());
        paths.writes(files.camera());
        paths.writes(files.annotations());
    }
}

void LayerExport::begin(const Scene& scene)
{
    scene_ = &scene;
    for (const FilmView& view : views_) requireWritableFolder(folderOf(view));
    things_.emplace(scene.world);
    rigs_ = rigsOf(scene, false);
}

void LayerExport::open(Gpu& gpu)
{
    stored_.emplace(scene_->world);
    for (const FilmView& view : views_)
        films_.push_back(std::make_unique<LayerFilm>(gpu, *scene_, view, LayerFiles{folderOf(view)}, *things_, rigs_));
}

void LayerExport::pass(const ExportFrame& frame)
{
    const ParticleView drawn = stored_->upload(*frame.view);
    for (const auto& film : films_) film->pass(frame, drawn);
}

void LayerExport::frame(const ExportFrame& frame)
{
    const ParticleView drawn = stored_->upload(*frame.view);
    for (const auto& film : films_) film->frame(frame, drawn);
}

void LayerExport::finish()
{
    for (const auto& film : films_) film->finish();
}

void LayerExport::close()
{
    films_.clear();
    stored_.reset();
}

}  // namespace knuckle
