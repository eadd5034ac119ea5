#pragma once

#include <span>

#include "render/settings.h"

namespace knuckle {

/// The content of a picture, and the direction of the view.
struct Framing {
    std::span<const Eigen::Vector3f> points;  ///< Not empty [m].
    float radius = 0.0f;                      ///< Of each of them [m].
    Eigen::Vector3f back{0, 0, 1};            ///< Unit, level or nearly, from them towards the camera.
    float fieldOfView = 40.0f;                ///< Vertical [degrees], 5 ... 120.
    float aspect = 1.0f;                      ///< Width over height.
    float share = 0.92f;                      ///< Share of the picture that they fill, in one direction or both, 0 ...
                                              ///< 1.
};

/// The camera nearest to the points that sees all of them, with them in the middle of its picture.
CameraSettings cameraThatFrames(const Framing& framing);

}  // namespace knuckle
