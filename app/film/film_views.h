#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "app/scene/scene_file.h"
#include "render/renderer.h"

namespace knuckle {

struct FilmOptions;

/// One of the films that a run makes of what it simulates.
struct FilmView {
    std::string camera;  ///< Its name; empty: the scene's own shots.
    RenderSettings picture;
    std::vector<size_t> outputs;  ///< Indices into FilmOptions::outputs.
};

/// "NAME=PATH" of --camera. @throws InputError for anything else.
struct CameraOutput {
    std::string camera, path;
    static CameraOutput parse(const std::string& text);
};

/// In the order in which outputs name them first. @throws InputError for a camera that the scene does not have.
std::vector<FilmView> viewsOf(const Scene& scene, const FilmOptions& options);

/// Of one frame of all of them.
Workload drawingWorkload(const std::vector<FilmView>& views);

}  // namespace knuckle
