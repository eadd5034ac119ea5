#include "render/view/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <vector>

#include "render/unseen.h"
#include "render/view/camera_keys.h"
#include "render/view/camera_shake.h"
#include "render/view/pleasant_view.h"
#include "sim/base/angles.h"
#include "sim/base/errors.h"
#include "sim/world/space/bounds.h"

namespace knuckle {

namespace {

using Eigen::AlignedBox3f;

/// Share of the picture that a followed object fills.
constexpr float FOLLOWED_SHARE = 0.8f;

AlignedBox3f grown(AlignedBox3f box, float sideways, float upwards)
{
    box.min() -= Vector3f(sideways, upwards, sideways);
    box.max() += Vector3f(sideways, upwards, sideways);
    return box;
}

/// The start, and some later times at which moving things reach most of their places [s].
std::vector<double> timesOfMotions(const World& world)
{
    constexpr int SAMPLES = 24;
    std::vector<double> times{0.0};
    for (const ColliderMotion& motion : world.colliderMotions)
        for (int k = 1; k <= SAMPLES; ++k)
            times.push_back(static_cast<double>(world.clips[motion.play.clip].duration()) * k / SAMPLES);
    return times;
}

void findGround(const World& world, SceneExtent& extent)
{
    bool seen = false;
    for (uint32_t i = 0; i < world.colliders.size(); ++i) {
        const Collider& collider = world.colliders[i];
        const bool level = (collider.orientation * Vector3f::UnitY()).y() > 0.9999f;
        if (collider.shape != ColliderShape::Plane || !level || moves(world, i)) continue;
        const bool isHigher = extent.groundCollider == NO_INDEX || collider.position.y() > extent.ground;
        if (collider.visible == seen ? !isHigher : seen) continue;
        seen = collider.visible;
        extent.ground = collider.position.y();
        extent.groundCollider = i;
    }
}

const Object& followedObject(const World& world, const std::string& name)
{
    const auto found = std::find_if(world.objects.begin(), world.objects.end(),
                                    [&](const Object& object) { return object.name == name && object.bodyCount > 0; });
    if (found != world.objects.end()) return *found;
    throw InputError(fmt::format("camera.follow: there is no object \"{}\" with a body; name one of the scene's "
                                 "objects",
                                 name));
}

/// Radius of the sphere about the middle of an object that holds its particles in nearly any pose [m].
float reachOf(const World& world, const Object& object)
{
    std::vector<Vector3f> positions;
    for (const Body& body : std::span(world.bodies).subspan(object.bodyStart, object.bodyCount))
        for (const Link& link : std::span(world.links).subspan(body.linkStart, body.linkCount))
            positions.push_back(world.particles[link.particle].position);
    Vector3f middle = Vector3f::Zero();
    for (const Vector3f& position : positions) middle += position / static_cast<float>(positions.size());
    float reach = 0.0f;
    for (const Vector3f& position : positions) reach = std::max(reach, (position - middle).norm());
    return reach + world.particleRadius;
}

}  // namespace

SceneExtent sceneExtent(const World& world)
{
    SceneExtent extent;
    findGround(world, extent);
    AlignedBox3f box = seenBounds(world);
    for (const double time : timesOfMotions(world))
        for (const Collider& collider : collidersAt(world, time))
            if (collider.visible && collider.shape != ColliderShape::Plane)
                extent.solids.extend(colliderBounds(world, collider));
    if (box.isEmpty()) box = extent.solids;
    if (box.isEmpty()) box = {Vector3f(-1, 0, -1), Vector3f(1, 1, 1)};
    if (extent.groundCollider != NO_INDEX) box.extend(Vector3f(box.center().x(), extent.ground, box.center().z()));
    // A huge obstacle (such as a box as floor) must not make the actors tiny.
    const float height = box.sizes().y(), reach = box.sizes().maxCoeff();
    const AlignedBox3f near = grown(box, 0.75f * reach, 0.5f * reach);
    const AlignedBox3f seenSolids = extent.solids.isEmpty() ? extent.solids : near.intersection(extent.solids);
    // Falling things spread.
    extent.stage = grown(box, 0.08f * height, 0.0f);
    if (!seenSolids.isEmpty()) extent.stage.extend(seenSolids);
    if (extent.groundCollider == NO_INDEX) extent.ground = extent.stage.min().y();
    extent.size = std::max(extent.stage.sizes().maxCoeff(), 4.0f * world.particleRadius);
    extent.limit = grown(extent.stage, 1.2f * extent.size, 0.3f * extent.size);
    return extent;
}

Camera::Camera(const CameraSettings& settings, const World& world, float aspect) : settings_(settings)
{
    if (settings.kind == CameraKind::Orbit) orbitSpeed_ = settings.orbitSpeed * DEGREE;
    if (settings.automatic) {
        mode_ = settings.kind == CameraKind::Orbit ? CAMERA_FRAMES_AROUND : CAMERA_FRAMES;
        settings_.position = pleasantDirection(world);
        settings_.target = Vector3f::Zero();
    }
    if (settings.attention == CameraAttention::Frame)
        mode_ = settings.kind == CameraKind::Orbit ? CAMERA_FRAMES_AROUND : CAMERA_FRAMES;
    if (settings.attention == CameraAttention::LookAt) mode_ = CAMERA_LOOKS;
    if (settings.kind == CameraKind::Follow) {
        const Object& object = followedObject(world, settings.follow);
        mode_ = CAMERA_FOLLOWS;
        followed_ = {object.bodyStart, object.bodyCount};
        for (const Body& body : std::span(world.bodies).subspan(object.bodyStart, object.bodyCount))
            followedAway_ += awayFrom(world, body) / static_cast<float>(object.bodyCount);
        const float slope = FOLLOWED_SHARE * std::tan(0.5f * settings.fieldOfView * DEGREE) * std::min(1.0f, aspect);
        // A sphere touches the view cone at a sine.
        if (settings.automatic) settings_.position *= reachOf(world, object) * std::sqrt(1.0f + 1.0f / (slope * slope));
    }
    const Vector3f arm = settings_.position - settings_.target;
    if (settings_.keys.empty() && (!arm.allFinite() || arm.norm() < 1e-6f))
        throw InputError("camera.position: it is the camera's target; move one of them");
}

void Camera::stand(const Vector3f& position, const Vector3f& target)
{
    const Vector3f arm = position - target;
    if (!arm.allFinite() || arm.norm() < 1e-6f) throw std::logic_error("a camera cannot look at its own place");
    settings_.position = position;
    settings_.target = target;
    settings_.keys.clear();
    settings_.focused.clear();
    settings_.shake = {};
    orbitSpeed_ = 0.0f;
    mode_ = CAMERA_FIXED;
    followed_ = {};
}

CameraAim Camera::at(double time) const
{
    CameraPose pose{settings_.position, settings_.target,   settings_.fieldOfView,
                    settings_.roll,     settings_.aperture, settings_.focus};
    if (!settings_.keys.empty()) pose = poseAt(settings_.keys, time);
    if (orbitSpeed_ != 0.0f) {
        const auto turn = static_cast<float>(std::remainder(orbitSpeed_ * time, 2.0 * std::numbers::pi));
        const Vector3f arm = pose.position - pose.target;
        pose.position = pose.target + Eigen::AngleAxisf(turn, Vector3f::UnitY()) * arm;
    }
    // Keys may cross: then it looks along -z for a moment instead of nowhere.
    if ((pose.position - pose.target).norm() < 1e-6f) pose.target = pose.position - Vector3f::UnitZ();
    CameraAim aim{.position = pose.position,
                  .target = pose.target,
                  .turn = {0.0f, 0.0f, pose.roll * DEGREE},
                  .tanHalfFov = std::tan(0.5f * pose.fieldOfView * DEGREE),
                  .aperture = pose.aperture,
                  .focus = pose.focus};
    if (settings_.shake.amplitude > 0.0f) aim.turn += shakeAt(settings_.shake, time);
    return aim;
}

}  // namespace knuckle
