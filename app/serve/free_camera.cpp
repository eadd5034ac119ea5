#include "app/serve/free_camera.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

using Eigen::Vector3f;

namespace {

constexpr float STEEPEST = 1.55f;                  // [rad]
constexpr float NEAREST = 1e-3f, FARTHEST = 1e4f;  // [m]

}  // namespace

FreeCamera::FreeCamera(const LayerCamera& camera, float distance, uint32_t width, uint32_t height)
    : distance_(std::clamp(distance, NEAREST, FARTHEST)), tanHalfFov_(static_cast<float>(0.5 * height / camera.focal)),
      aspect_(static_cast<float>(width) / static_cast<float>(height))
{
    const Vector3f towards = camera.toWorld.linear().col(2).cast<float>();
    around_ = std::atan2(towards.x(), towards.z());
    above_ = std::clamp(std::asin(std::clamp(towards.y(), -1.0f, 1.0f)), -STEEPEST, STEEPEST);
    target_ = camera.toWorld.translation().cast<float>() - distance_ * back();
}

void FreeCamera::orbit(const Eigen::Vector2f& by)
{
    around_ = std::remainder(around_ - by.x(), 6.2831853f);
    above_ = std::clamp(above_ - by.y(), -STEEPEST, STEEPEST);
}

void FreeCamera::pan(const Eigen::Vector2f& by)
{
    const Vector3f right = Vector3f::UnitY().cross(back()).normalized(), up = back().cross(right);
    const float height = 2.0f * distance_ * tanHalfFov_;
    const Vector3f moved = target_ - height * (by.x() * right + by.y() * up);
    if (moved.allFinite() && moved.norm() < FARTHEST) target_ = moved;
}

void FreeCamera::zoom(float factor)
{
    distance_ = std::clamp(distance_ * factor, NEAREST, FARTHEST);
}

Vector3f FreeCamera::placeAt(const Eigen::Vector2f& at, float depth) const
{
    const Vector3f right = Vector3f::UnitY().cross(back()).normalized(), up = back().cross(right);
    const float across = (2.0f * at.x() - 1.0f) * tanHalfFov_ * aspect_, above = (1.0f - 2.0f * at.y()) * tanHalfFov_;
    return position() + depth * (across * right + above * up - back());
}

Vector3f FreeCamera::back() const
{
    return {std::cos(above_) * std::sin(around_), std::sin(above_), std::cos(above_) * std::cos(around_)};
}

}  // namespace knuckle
