#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "app/files/run_paths.h"
#include "app/scene/scene_file.h"
#include "sim/solver/measure/state.h"

namespace knuckle {

/// What an exporter asks for: of the scene its surfaces, of each frame what is read back.
struct ExportNeeds {
    bool surfaces = false;  ///< Meshes of models with materials and textures, see loadScene().
    bool particles = false, bodies = false, measures = false;
};

/// One frame of a run. Null is what no exporter of the run needs.
struct ExportFrame {
    uint64_t number = 1;  ///< As in frame_0001.png.
    const World& world;
    const ParticleState* particles = nullptr;
    const std::vector<BodyState>* bodies = nullptr;  ///< As World::bodies.
    const Measures* measures = nullptr;
};

/// What `--export KIND=PATH` writes of a run: begin(), frame() of each frame drawn, finish(). It is made before the
/// scene is read, and opens nothing until begin(). A format is a class of this kind, and a line in exporters.cpp.
class Exporter {
public:
    /// @throws InputError for a path that it cannot write to for reasons of its own.
    explicit Exporter(std::string path) : path_(std::move(path)) {}
    virtual ~Exporter() = default;
    Exporter(const Exporter&) = delete;
    Exporter& operator=(const Exporter&) = delete;

    const std::string& path() const { return path_; }
    virtual ExportNeeds needs() const = 0;
    /// Adds what it will write: one file, if it does not say otherwise. @throws InputError as RunPaths does.
    virtual void addPaths(const Scene& /*scene*/, RunPaths& paths) const { paths.writes(path_); }
    /// What of a world has no place in the file, as "colliders": a note tells.
    virtual std::vector<std::string> leftOut(const World& /*world*/) const { return {}; }
    /// Opens its files. @throws InputError for what cannot be written, and a scene without what it writes.
    virtual void begin(const Scene& scene) = 0;
    /// Of the next frame. @throws RunError from a full disk, as finish() does.
    virtual void frame(const ExportFrame& frame) = 0;
    virtual void finish() = 0;

private:
    std::string path_;
};

}  // namespace knuckle
