#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/files/run_paths.h"
#include "app/film/film_views.h"
#include "app/scene/scene_file.h"
#include "sim/solver/measure/view_state.h"

namespace knuckle {

/// Requirements of an exporter: surfaces of the scene, and data read back for each frame.
struct ExportNeeds {
    bool surfaces = false;  ///< Meshes of models with materials and textures, see loadScene().
    bool particles = false, bodies = false, measures = false, densities = false;
    bool views = false;  ///< ViewState of every frame from the first on, and the cameras of the run.
};

/// One frame of a run. Members that no exporter of the run needs are null.
struct ExportFrame {
    uint64_t number = 1;  ///< As in frame_0001.png.
    const World& world;
    const ViewState* view = nullptr;
    const ParticleState* particles = nullptr;
    const std::vector<BodyState>* bodies = nullptr;  ///< As World::bodies.
    const Measures* measures = nullptr;
    const std::vector<float>* densities = nullptr;  ///< As FrameRecord::densities; null: of stored states.
};

/// A writer of `--export KIND=PATH`: begin(), frame() for each drawn frame, finish(). It is made before the scene is
/// read, and opens nothing until begin(). Each format is a class of this kind, and a line in exporters.cpp.
class Exporter {
public:
    /// @throws InputError for a path that this format cannot be written to.
    explicit Exporter(std::string path) : path_(std::move(path)) {}
    virtual ~Exporter() = default;
    Exporter(const Exporter&) = delete;
    Exporter& operator=(const Exporter&) = delete;

    const std::string& path() const { return path_; }
    virtual ExportNeeds needs() const = 0;
    /// Adds its output: one file, unless overridden. @throws InputError as RunPaths does.
    virtual void addPaths(const Scene& /*scene*/, RunPaths& paths) const { paths.writes(path_); }
    /// Parts of a world that the file cannot represent, such as "colliders", for a note.
    virtual std::vector<std::string> leftOut(const World& /*world*/) const { return {}; }
    /// What the cameras of the run film, before addPaths().
    virtual void setViews(const std::vector<FilmView>& /*views*/) {}
    /// Opens its files. @throws InputError for files that cannot be written, and a scene without matter for it.
    virtual void begin(const Scene& scene) = 0;
    /// Writes the next frame. @throws RunError from a full disk, as finish() does.
    virtual void frame(const ExportFrame& frame) = 0;
    virtual void finish() = 0;
    /// For what draws: after begin(), a device until close().
    virtual void open(Gpu& /*gpu*/) {}
    virtual void close() {}
    /// A frame before those that are to be written; only with ExportNeeds::views.
    virtual void pass(const ExportFrame& /*frame*/) {}

private:
    std::string path_;
};

}  // namespace knuckle
