#pragma once

#include <Eigen/Core>

#include "render/layers/layers.h"

namespace knuckle {

/// A camera that a viewer turns about what it looks at; it never lies on its side.
class FreeCamera {
public:
    FreeCamera() = default;
    /// As another one stands. @param distance to what it turns about [m].
    FreeCamera(const LayerCamera& camera, float distance, uint32_t width, uint32_t height);

    /// The picture turns to the right and up by angles [rad].
    void orbit(const Eigen::Vector2f& by);
    /// The picture moves to the right and up, in shares of its height.
    void pan(const Eigen::Vector2f& by);
    /// @param factor of the distance.
    void zoom(float factor);

    Eigen::Vector3f position() const { return target_ + distance_ * back(); }
    const Eigen::Vector3f& target() const { return target_; }
    /// The place at a depth along its axis [m]. @param at from the upper left corner, in shares of the picture.
    Eigen::Vector3f placeAt(const Eigen::Vector2f& at, float depth) const;

private:
    Eigen::Vector3f back() const;

    Eigen::Vector3f target_{0, 0, 0};
    float distance_ = 1.0f;  ///< [m]
    float around_ = 0.0f,
          above_ = 0.0f;  ///< Of the direction towards the camera: about +Y from +Z, over the level [rad].
    float tanHalfFov_ = 0.36f, aspect_ = 1.0f;
};

}  // namespace knuckle
