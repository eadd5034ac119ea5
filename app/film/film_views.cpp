#include "app/film/film_views.h"

#include <fmt/format.h>

#include <algorithm>

#include "app/film/film_run.h"
#include "app/json/json.h"
#include "sim/base/errors.h"

namespace knuckle {

CameraOutput CameraOutput::parse(const std::string& text)
{
    const size_t sign = text.find('=');
    if (sign == 0 || sign == std::string::npos || sign + 1 == text.size())
        throw InputError(fmt::format("--camera {}: must be NAME for everything, or NAME=OUTPUT as often as there are "
                                     "outputs for cameras",
                                     text));
    return {text.substr(0, sign), text.substr(sign + 1)};
}

std::vector<FilmView> viewsOf(const Scene& scene, const FilmOptions& options)
{
    std::vector<FilmView> views;
    for (size_t k = 0; k < options.outputs.size(); ++k) {
        const std::string camera = k < options.cameras.size() ? options.cameras[k] : "";
        auto view = std::ranges::find(views, camera, &FilmView::camera);
        if (view == views.end()) {
            std::vector<std::string> names;
            for (const auto& [name, settings] : scene.render.cameras) names.push_back(name);
            if (!camera.empty() && !scene.render.cameras.contains(camera))
                throw InputError(fmt::format("--camera {}={}: there is no camera \"{}\"; {}", camera,
                                             options.outputs[k], camera, suggestion(camera, names)));
            view = views.insert(views.end(),
                                {camera, camera.empty() ? scene.render : filmedBy(scene.render, camera), {}});
        }
        view->outputs.push_back(k);
    }
    return views;
}

Workload drawingWorkload(const std::vector<FilmView>& views)
{
    Workload work;
    for (const FilmView& view : views) work = work + drawingWorkload(view.picture);
    return work;
}

}  // namespace knuckle
