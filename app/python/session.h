#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "app/python/session_end.h"
#include "app/scene/scene_file.h"
#include "render/layers/layer_renderer.h"
#include "render/layers/scene_things.h"
#include "render/renderer.h"
#include "sim/solver/stepped_solver.h"

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
    uint64_t world = 0;  ///< Its fingerprint.
    SolverState solver;
};

/// A scene on the device, its steps and its pictures, for Python. All calls must come from the thread that made it,
/// else they throw std::logic_error. Errors as those of Solver and Renderer.
class Session {
public:
    /// @param device as `--device`.
    Session(std::shared_ptr<const Scene> scene, const std::string& device);

    const Scene& scene() const { return *scene_; }
    const std::string& deviceName() const { return solver_.gpu().device().name; }
    /// Advances by steps of Settings::timeStep.
    void step(uint32_t count) { solver_.step(count); }
    uint64_t steps() const { return solver_.steps(); }
    /// Since the start [s].
    double time() const { return solver_.time(); }
    ParticleState particles() { return solver_.here().readParticles(); }
    std::vector<BodyState> bodies() { return solver_.here().readBodies(); }
    Measures measure() { return solver_.here().measure(); }
    uint64_t hash() { return solver_.here().stateHash(); }
    SessionState save();
    /// @throws InputError if it is of another world.
    void load(const SessionState& state);
    Image picture(const PictureWish& wish);
    /// Pictures as numbers; the quality does not count. What moves from frame to frame is not known.
    Layers layers(const PictureWish& wish);
    const SceneThings& things() const { return things_; }
    const std::shared_ptr<SessionEnds>& ends() const { return ends_; }

    // Changes before the next step. Names are "object", or "object/body"; @throws InputError for names that are not
    // there, numbers that are not finite, and what is held or follows a clip.
    /// An object's bodies move as one, about the first. @param velocity of its mass centre. @param spin [rad/s]
    void setVelocity(const std::string& name, const Vector3f& velocity, const Vector3f& spin);
    /// Of the first body's mass centre; the others of an object come along.
    void setPose(const std::string& name, const Vector3f& position, const std::optional<Quaternionf>& rotation);
    /// @param impulse [N s]. @param at  a place [m], else the mass centre.
    void applyImpulse(const std::string& name, const Vector3f& impulse, const std::optional<Vector3f>& at);
    /// Lets go of a body and all that hangs on it.
    void release(const std::string& name);
    /// Drives a joint that has a motor or a spring otherwise.
    void drive(const std::string& name, const TurnDrive& drive);
    std::vector<ContactForce> contactForces() { return solver_.here().contactForces(); }

private:
    RenderSettings settingsFor(const PictureWish& wish) const;
    uint64_t worldMark();

    std::shared_ptr<const Scene> scene_;
    SteppedSolver solver_;
    std::shared_ptr<SessionEnds> ends_ = sessionEnds();
    std::optional<uint64_t> worldMark_;  ///< Fingerprint of its world, once it was asked for.
    SceneThings things_;
    std::map<PictureWish, std::unique_ptr<Renderer>> renderers_;            ///< MOST_RENDERERS at most.
    std::map<PictureWish, std::unique_ptr<LayerRenderer>> layerRenderers_;  ///< The same.
};

}  // namespace knuckle
