#pragma once

#include <memory>
#include <optional>
#include <string>

#include "app/scene/scene_file.h"
#include "app/serve/change.h"
#include "app/serve/free_camera.h"
#include "render/layers/layer_renderer.h"
#include "render/layers/scene_things.h"

namespace knuckle {

/// What is under the mouse.
struct Picked {
    std::string name;                ///< "object", "object/body"; empty: nothing that has a name.
    uint32_t body = NO_INDEX;        ///< If it is one.
    Eigen::Vector3f place{0, 0, 0};  ///< [m]
    float depth = 0.0f;              ///< Along the camera's axis [m].
};

/// The hand of viewers: finds what is under the mouse, and drags it.
class Hand {
public:
    /// @param settings as pictures are drawn.
    Hand(Gpu& gpu, const World& world, const RenderSettings& settings);

    /// @param at from the upper left corner, in shares of the picture. The first call compiles what it needs.
    Picked pick(const ParticleView& view, double time, const FreeCamera& camera, const Eigen::Vector2f& at);
    /// Holds a body where it was picked. @param pose of the body.
    void grab(const Picked& picked, const BodyState& pose);
    void moveTo(const Eigen::Vector3f& place) { target_ = place; }
    void drop() { body_.reset(); }
    bool holds() const { return body_.has_value(); }
    uint32_t body() const { return *body_; }
    float depth() const { return depth_; }
    /// The push of a step, as large as MOST_WEIGHTS times the weight of what hangs together.
    Change pull(const BodyState& pose) const;
    /// Of a body [kg].
    double massOf(uint32_t body) const;

    static constexpr float MOST_WEIGHTS = 4.0f;

private:
    Gpu& gpu_;
    const World& world_;
    RenderSettings settings_;
    SceneThings things_;
    std::unique_ptr<LayerRenderer> layers_;
    std::optional<uint32_t> body_;
    Eigen::Vector3f held_{0, 0, 0}, target_{0, 0, 0};  ///< In the body's axes; in the world [m].
    float depth_ = 0.0f, strength_ = 0.0f;             ///< [m], [N]
};

}  // namespace knuckle
