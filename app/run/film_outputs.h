#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/export/bvh.h"
#include "app/export/gltf.h"
#include "app/files/export.h"
#include "app/files/run_paths.h"
#include "app/run/film_run.h"
#include "app/run/frame_drawing.h"

namespace knuckle {

/// Whether `-o path` is a film, else a folder for frames: a stream is one, and a name that ends like one. A slash at
/// the end makes any name a folder's.
/// @throws InputError for another ending, and for a film's name where a folder stands.
bool isFilm(const std::string& path);

/// Adds all that a run writes. @throws InputError as RunPaths does.
void addOutputs(const FilmOptions& options, const Scene& scene, RunPaths& paths);

/// Everything that is written, opened before the first step so that nothing is simulated in vain.
struct FilmOutputs {
    FrameSinks sinks;
    std::optional<BodyTable> bodies;
    std::optional<MeasureTable> measures;
    std::optional<BvhExport> bvh;
    std::optional<GltfExport> gltf;
    std::optional<OutputFile> stats;
    std::string plyFolder;

    /// @throws InputError for what cannot be written.
    FilmOutputs(const Scene& scene, const FilmOptions& options);
    bool wantBodies() const { return bodies || bvh || gltf; }
    void addBodies(uint64_t frame, const World& world, const std::vector<BodyState>& states);
    /// All but the sinks and the figures. @throws RunError.
    void finishTables(double framesPerSecond);
};

}  // namespace knuckle
