#include "render/view/framing.h"

#include <algorithm>
#include <cmath>

#include "sim/base/angles.h"
#include "sim/world/space/frames.h"

namespace knuckle {

using Eigen::Array2f;
using Eigen::Vector3f;

CameraSettings cameraThatFrames(const Framing& framing)
{
    const Vector3f right = levelRight(framing.back), up = framing.back.cross(right);
    const float half = framing.share * std::tan(0.5f * DEGREE * framing.fieldOfView);
    const Array2f slope(half * framing.aspect, half);
    // For each side of the view, how far out or away a point requires the camera to be.
    Array2f most = Array2f::Constant(-1e30f), least = Array2f::Constant(1e30f);
    for (const Vector3f& point : framing.points) {
        const Array2f side(point.dot(right), point.dot(up)), reach = framing.radius * (1.0f + slope.square()).sqrt();
        most = most.max(side + slope * point.dot(framing.back) + reach);
        least = least.min(side - slope * point.dot(framing.back) - reach);
    }
    const Array2f middle = 0.5f * (most + least), away = 0.5f * (most - least) / slope;
    CameraSettings camera;
    camera.automatic = false;
    camera.fieldOfView = framing.fieldOfView;
    camera.position = middle.x() * right + middle.y() * up + away.maxCoeff() * framing.back;
    camera.target = camera.position - framing.back;
    return camera;
}

}  // namespace knuckle
