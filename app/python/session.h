#pragma once

#include <map>
#include <memory>
#include <string>
#include <thread>
#include <tuple>
#include <vector>

#include "app/scene/scene_file.h"
#include "render/renderer.h"
#include "sim/solver/solver.h"

namespace knuckle {

/// How a picture of a Session differs from what its scene says.
struct PictureWish {
    uint32_t width = 640, height = 360;  ///< [pixels]
    std::string quality;                 ///< draft, good or final; empty: the scene's.
    std::string camera;                  ///< JSON of a camera as scene files have it; empty: the scene's shots.

    bool operator<(const PictureWish& other) const
    {
        return std::tie(width, height, quality, camera) <
               std::tie(other.width, other.height, other.quality, other.camera);
    }
};

/// A state of a Session, to return to.
struct SessionState {
    uint64_t steps = 0;
    SolverState solver;
};

/// A scene on the device, its steps and its pictures, for Python. All calls must come from the thread that made it,
/// else they throw std::logic_error. Errors as those of Solver and Renderer.
class Session {
public:
    /// @param device as `--device`.
    Session(std::shared_ptr<const Scene> scene, const std::string& device);

    const Scene& scene() const { return *scene_; }
    const std::string& deviceName() const { return gpu_->device().name; }
    /// Advances by steps of Settings::timeStep.
    void step(uint32_t count);
    uint64_t steps() const { return steps_; }
    /// Since the start [s].
    double time() const;
    ParticleState particles() { return here().readParticles(); }
    std::vector<BodyState> bodies() { return here().readBodies(); }
    Measures measure() { return here().measure(); }
    uint64_t hash() { return here().stateHash(); }
    SessionState save();
    /// @throws std::logic_error if it is of another scene.
    void load(const SessionState& state);
    Image picture(const PictureWish& wish);

private:
    Solver& here();
    RenderSettings settingsFor(const PictureWish& wish) const;

    std::shared_ptr<const Scene> scene_;
    std::thread::id thread_ = std::this_thread::get_id();
    std::shared_ptr<Gpu> gpu_;
    Solver solver_;
    uint64_t steps_ = 0;
    std::map<PictureWish, std::unique_ptr<Renderer>> renderers_;
};

}  // namespace knuckle
