#pragma once

#include <Eigen/Geometry>

#include "render/settings.h"
#include "shared/frame_types.h"
#include "sim/world/world.h"

namespace knuckle {

/// Where things are at the start and where they will fall, for framing and for the light [m].
struct SceneExtent {
    Eigen::AlignedBox3f stage;           ///< What a picture should show.
    Eigen::AlignedBox3f limit;           ///< Beyond it nothing casts a shadow.
    Eigen::AlignedBox3f solids;          ///< Visible finite colliders; empty without any.
    float size = 1.0f;                   ///< Largest side of the stage, > 0.
    float ground = 0.0f;                 ///< Height of the ground plane, or the stage's floor where there is none.
    uint32_t groundCollider = NO_INDEX;  ///< The highest level plane, of those that are seen where there are some.
};

SceneExtent sceneExtent(const World& world);

/// A camera at one moment, before the GPU moves it: an offset from what it follows, or the side from which it looks.
struct CameraAim {
    Vector3f position, target;
};

/// Bodies one after another.
struct BodyRange {
    uint32_t start = 0, count = 0;
};

/// The camera of a scene, except for what only the GPU knows.
class Camera {
public:
    /// @throws InputError for an unknown object, or where position and target are the same.
    Camera(const CameraSettings& settings, const World& world, float aspect);

    CameraAim at(double time) const;
    /// CAMERA_FIXED, ...
    uint32_t mode() const { return mode_; }
    /// CAMERA_FOLLOWS: the object's bodies.
    BodyRange followed() const { return followed_; }
    float tanHalfFov() const { return tanHalfFov_; }

private:
    CameraAim start_;
    float orbitSpeed_ = 0.0f;  ///< [rad/s]
    float tanHalfFov_;
    uint32_t mode_ = CAMERA_FIXED;
    BodyRange followed_;
};

}  // namespace knuckle
