#pragma once

#include <Eigen/Geometry>

#include "render/settings.h"
#include "sim/world/world.h"

namespace knuckle {

/// Where things are at the start and where they will fall, for framing and for the light [m].
struct SceneExtent {
    Eigen::AlignedBox3f stage;      ///< What a picture should show.
    Eigen::AlignedBox3f limit;      ///< Beyond it nothing casts a shadow.
    Eigen::AlignedBox3f solids;     ///< Visible finite colliders; empty without any.
    float size = 1.0f;              ///< Largest side of the stage, > 0.
    float ground = 0.0f;            ///< Height of the ground plane, or the stage's floor where there is none.
    uint32_t groundCollider = NO_INDEX;   ///< The highest level plane.
};

SceneExtent sceneExtent(const World& world);

/// A camera at one moment. Where it follows a body, both points are offsets from that body's centre.
struct CameraAim {
    Vector3f position, target;
};

/// The camera of a scene, except for what only the GPU knows.
class Camera {
public:
    /// @throws InputError for an unknown object, equal position and target, or an angle out of range.
    Camera(const CameraSettings& settings, const World& world, const SceneExtent& extent, float aspect);

    CameraAim at(double time) const;
    /// The body it follows, else NO_INDEX.
    uint32_t followedBody() const { return followedBody_; }
    float tanHalfFov() const { return tanHalfFov_; }

private:
    CameraKind kind_;
    CameraAim start_;
    float orbitSpeed_;               ///< [rad/s]
    float tanHalfFov_;
    uint32_t followedBody_ = NO_INDEX;
};

}  // namespace knuckle
