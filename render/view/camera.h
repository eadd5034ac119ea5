#pragma once

#include <Eigen/Geometry>

#include "render/settings.h"
#include "shared/frame_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Extent of things at the start and where they will fall, for framing and for the light [m].
struct SceneExtent {
    Eigen::AlignedBox3f stage;           ///< The part that a picture should show.
    Eigen::AlignedBox3f limit;           ///< Nothing casts a shadow beyond it.
    Eigen::AlignedBox3f solids;          ///< Visible finite colliders; empty if there are none.
    float size = 1.0f;                   ///< Largest side of the stage, > 0.
    float ground = 0.0f;                 ///< Height of the ground plane, or the stage's floor if there is none.
    uint32_t groundCollider = NO_INDEX;  ///< The highest level plane, among the visible ones if there are any.
};

SceneExtent sceneExtent(const World& world);

/// A camera at one moment, before the GPU moves it: an offset from what it follows, or the side that it looks from.
struct CameraAim {
    Vector3f position, target;  ///< [m]
    Vector3f turn;              ///< To the left, up, and counter-clockwise, after it is aimed [rad].
    float tanHalfFov = 0.0f;    ///< Vertical.
    float aperture = 0.0f;      ///< [m], as CameraSettings::aperture.
    float focus = 0.0f;         ///< [m], as CameraSettings::focus.
};

/// Bodies one after another.
struct BodyRange {
    uint32_t start = 0, count = 0;
};

/// A camera of a scene, as far as the host knows it.
class Camera {
public:
    /// @throws InputError for an unknown object, or if position and target are equal.
    Camera(const CameraSettings& settings, const World& world, float aspect);

    /// @param time of the film [s].
    CameraAim at(double time) const;
    /// From now on it stands there and does nothing else; its field of view, roll and lens stay.
    /// @throws std::logic_error if position and target are nearly equal or not finite.
    void stand(const Vector3f& position, const Vector3f& target);
    /// CAMERA_FIXED, ...
    uint32_t mode() const { return mode_; }
    /// CAMERA_FOLLOWS: the object's bodies.
    BodyRange followed() const { return followed_; }
    /// CAMERA_FOLLOWS: where the object waits before it is there, from where it will be, in the mean of its bodies [m].
    const Vector3f& followedAway() const { return followedAway_; }
    const CameraSettings& settings() const { return settings_; }

private:
    CameraSettings settings_;
    float orbitSpeed_ = 0.0f;  ///< [rad/s]
    uint32_t mode_ = CAMERA_FIXED;
    BodyRange followed_;
    Vector3f followedAway_{0, 0, 0};
};

}  // namespace knuckle
