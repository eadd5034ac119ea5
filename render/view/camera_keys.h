#pragma once

#include <Eigen/Core>
#include <span>

#include "render/camera_settings.h"

namespace knuckle {

/// All of a camera that keys change.
struct CameraPose {
    Eigen::Vector3f position, target;     ///< [m]
    float fieldOfView = 40.0f;            ///< Vertical [degrees].
    float roll = 0.0f;                    ///< [degrees]
    float aperture = 0.0f, focus = 0.0f;  ///< [m]
};

/// The camera at a time of the film [s]: passes through every key, and stays before the first and after the last.
/// Curves are monotone cubics in each component (Fritsch and Carlson), so that a camera with all keys above a floor
/// never dips below it. @param keys in order of time, not empty.
CameraPose poseAt(std::span<const CameraKey> keys, double time);

}  // namespace knuckle
