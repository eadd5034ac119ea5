#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/scene/scene_file.h"
#include "app/serve/changes/change.h"
#include "app/serve/free_camera.h"
#include "render/layers/layer_renderer.h"
#include "render/layers/scene_things.h"
#include "sim/solver/edit/clump.h"

namespace knuckle {

/// What is under the mouse.
struct Picked {
    std::string name;                       ///< "object", "object/body"; empty: nothing that has a name.
    uint32_t body = NO_INDEX;               ///< If it is one.
    uint32_t firstLoose = 0, endLoose = 0;  ///< Particles of fluids, grains, cloth and all else without bodies.
    Eigen::Vector3f place{0, 0, 0};         ///< [m]
    float depth = 0.0f;                     ///< Along the camera's axis [m].

    bool canBePulled() const { return body != NO_INDEX || endLoose > firstLoose; }
};

/// The hand of viewers: finds what is under the mouse, and drags it.
class Hand {
public:
    /// @param settings as pictures are drawn.
    Hand(Gpu& gpu, const World& world, const RenderSettings& settings);

    /// @param at from the upper left corner, in shares of the picture. The first call compiles what it needs.
    Picked pick(const ParticleView& view, double time, const FreeCamera& camera, const Eigen::Vector2f& at);
    /// Holds what was picked: a body where it was picked, else the particles around that place.
    void grab(const Picked& picked, Solver& solver);
    void moveTo(const Eigen::Vector3f& place) { target_ = place; }
    void drop() { held_.reset(); }
    bool holds() const { return held_.has_value(); }
    float depth() const { return held_->depth; }
    /// What pulls it for a step, as large as MOST_WEIGHTS times the weight of what hangs together; of fluids and
    /// grains, of what is held. None if nothing is there any more, as when a hand has been pulled out of water.
    std::optional<Change> pull(Solver& solver);
    /// Of a body [kg].
    double massOf(uint32_t body) const;

    static constexpr float MOST_WEIGHTS = 4.0f;

private:
    struct Held {
        Picked picked;
        uint32_t particle = NO_INDEX;       ///< Of cloth, ropes and soft bodies.
        Eigen::Vector3f place{0, 0, 0};     ///< In the body's axes; of particles, in the world [m].
        float depth = 0.0f, radius = 0.0f;  ///< [m]
        float strength = 0.0f;              ///< [N]; 0: as what is held weighs.
    };
    Change pullBody(const BodyState& pose) const;
    std::optional<Change> pullLoose(const ParticleState& state);
    Clump clumpOf(const Held& held, const ParticleState& state) const;
    void holdLoose(Held& held, const ParticleState& state) const;
    Eigen::Vector3f wanted(const Eigen::Vector3f& place) const;

    Gpu& gpu_;
    const World& world_;
    RenderSettings settings_;
    SceneThings things_;
    std::unique_ptr<LayerRenderer> layers_;
    std::optional<Held> held_;
    Eigen::Vector3f target_{0, 0, 0};  ///< [m]
};

}  // namespace knuckle
