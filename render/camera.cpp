#include "render/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

using Eigen::AlignedBox3f;

constexpr float DEGREE = std::numbers::pi_v<float> / 180.0f;
/// From where a scene looks best: a little to the right, a little from above.
constexpr float PLEASANT_AZIMUTH = 28.0f * DEGREE;
constexpr float PLEASANT_ELEVATION = 17.0f * DEGREE;
/// Room around what is framed.
constexpr float FRAME_MARGIN = 0.98f;

AlignedBox3f boundsOf(const Collider& collider)
{
    Vector3f half = collider.halfExtents;
    if (collider.shape == ColliderShape::Sphere) half = Vector3f::Constant(collider.radius);
    if (collider.shape == ColliderShape::Capsule)
        half = {collider.radius, collider.radius + collider.halfHeight, collider.radius};
    const Eigen::Matrix3f axes = collider.orientation.normalized().toRotationMatrix().cwiseAbs();
    const Vector3f reach = axes * half;
    return {collider.position - reach, collider.position + reach};
}

AlignedBox3f grown(AlignedBox3f box, float sideways, float upwards)
{
    box.min() -= Vector3f(sideways, upwards, sideways);
    box.max() += Vector3f(sideways, upwards, sideways);
    return box;
}

AlignedBox3f particleBounds(const World& world)
{
    AlignedBox3f box;
    for (const Particle& particle : world.particles) box.extend(particle.position);
    if (!box.isEmpty()) box = grown(box, world.particleRadius, world.particleRadius);
    return box;
}

void findGround(const World& world, SceneExtent& extent)
{
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& collider = world.colliders[i];
        const bool level = (collider.orientation * Vector3f::UnitY()).y() > 0.9999f;
        if (collider.shape != ColliderShape::Plane || !level) continue;
        if (extent.groundCollider != NO_INDEX && collider.position.y() <= extent.ground) continue;
        extent.ground = collider.position.y();
        extent.groundCollider = i;
    }
}

/// Distance from the centre of `box` at which all of it is seen from the direction `back`.
float framingDistance(const AlignedBox3f& box, const Vector3f& back, float tanHalfFov, float aspect)
{
    const Vector3f right = Vector3f::UnitY().cross(back).normalized(), up = back.cross(right);
    float distance = 0.0f;
    for (int corner = 0; corner < 8; ++corner) {
        const Vector3f p = box.corner(static_cast<AlignedBox3f::CornerType>(corner)) - box.center();
        const float across = std::max(std::abs(p.dot(right)) / aspect, std::abs(p.dot(up)));
        distance = std::max(distance, FRAME_MARGIN * across / tanHalfFov + p.dot(back));
    }
    return distance;
}

uint32_t rootBodyOf(const World& world, const std::string& name)
{
    for (const Object& object : world.objects) {
        if (object.name == name && object.rootBody != NO_INDEX) return object.rootBody;
        if (object.name == name && object.bodyCount > 0) return object.bodyStart;
    }
    throw InputError(fmt::format("camera.follow: there is no object \"{}\" with a body; name one of the scene's "
                                 "objects", name));
}

void requireRange(float value, float low, float high, const char* field)
{
    if (value >= low && value <= high) return;
    throw InputError(fmt::format("camera.{}: {} is outside {} ... {}", field, value, low, high));
}

}  // namespace

SceneExtent sceneExtent(const World& world)
{
    SceneExtent extent;
    findGround(world, extent);
    AlignedBox3f box = particleBounds(world);
    for (const Collider& collider : world.colliders)
        if (collider.visible && collider.shape != ColliderShape::Plane) extent.solids.extend(boundsOf(collider));
    if (box.isEmpty()) box = extent.solids;
    if (box.isEmpty()) box = {Vector3f(-1, 0, -1), Vector3f(1, 1, 1)};
    if (extent.groundCollider != NO_INDEX) box.extend(Vector3f(box.center().x(), extent.ground, box.center().z()));
    // A huge obstacle (a floor made of a box) must not make the actors tiny.
    const float height = box.sizes().y(), reach = box.sizes().maxCoeff();
    const AlignedBox3f near = grown(box, 0.75f * reach, 0.5f * reach);
    const AlignedBox3f seenSolids = extent.solids.isEmpty() ? extent.solids : near.intersection(extent.solids);
    // What falls spreads.
    extent.stage = grown(box, 0.08f * height, 0.0f);
    if (!seenSolids.isEmpty()) extent.stage.extend(seenSolids);
    if (extent.groundCollider == NO_INDEX) extent.ground = extent.stage.min().y();
    extent.size = std::max(extent.stage.sizes().maxCoeff(), 4.0f * world.particleRadius);
    extent.limit = grown(extent.stage, 1.2f * extent.size, 0.3f * extent.size);
    return extent;
}

Camera::Camera(const CameraSettings& settings, const World& world, const SceneExtent& extent, float aspect)
    : kind_(settings.kind), start_{settings.position, settings.target}, orbitSpeed_(settings.orbitSpeed * DEGREE),
      tanHalfFov_(std::tan(0.5f * settings.fieldOfView * DEGREE))
{
    requireRange(settings.fieldOfView, 5.0f, 120.0f, "fieldOfView");
    if (kind_ == CameraKind::Follow) followedBody_ = rootBodyOf(world, settings.follow);
    if (settings.automatic) {
        const Vector3f back(std::sin(PLEASANT_AZIMUTH) * std::cos(PLEASANT_ELEVATION), std::sin(PLEASANT_ELEVATION),
                            std::cos(PLEASANT_AZIMUTH) * std::cos(PLEASANT_ELEVATION));
        AlignedBox3f box = extent.stage;
        if (kind_ == CameraKind::Orbit) {
            // Seen from all sides in turn: frame the circle that the stage's corners describe.
            const float around = 0.5f * std::hypot(box.sizes().x(), box.sizes().z());
            const Vector3f half(around, 0.5f * box.sizes().y(), around);
            box = AlignedBox3f(box.center() - half, box.center() + half);
        }
        const float distance = framingDistance(box, back, tanHalfFov_, aspect);
        const bool follows = kind_ == CameraKind::Follow;
        start_.target = follows ? Vector3f::Zero() : Vector3f(box.center());
        start_.position = start_.target + back * (follows ? 0.7f * distance : distance);
    }
    if (!(start_.position - start_.target).allFinite() || (start_.position - start_.target).norm() < 1e-6f)
        throw InputError("camera.position: it is the camera's target; move one of them");
}

CameraAim Camera::at(double time) const
{
    if (kind_ != CameraKind::Orbit) return start_;
    const auto turn = static_cast<float>(std::remainder(orbitSpeed_ * time, 2.0 * std::numbers::pi));
    const Vector3f arm = start_.position - start_.target;
    return {start_.target + Eigen::AngleAxisf(turn, Vector3f::UnitY()) * arm, start_.target};
}

}  // namespace knuckle
