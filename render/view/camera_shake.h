#pragma once

#include <Eigen/Core>

#include "render/camera_settings.h"

namespace knuckle {

/// How a hand turns the camera at a time of the film [s]: to the left, up, and counter-clockwise [rad]. Smooth, zero on
/// average, and the same whichever frames are drawn. Rolls half as far as it pans and tilts.
Eigen::Vector3f shakeAt(const CameraShake& shake, double time);

}  // namespace knuckle
