#include "app/serve/hand.h"

#include <algorithm>
#include <cmath>

#include "app/scene/joints/scene_joints.h"
#include "sim/solver/layout/body_mass.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;

constexpr float EAGERNESS = 8.0f;  // how fast it comes to the mouse [1/s]
constexpr float FASTEST = 10.0f;   // [m/s]

}  // namespace

Hand::Hand(Gpu& gpu, const World& world, const RenderSettings& settings)
    : gpu_(gpu), world_(world), settings_(settings), things_(world)
{
    // Half as fine as the picture: a quarter of the work.
    settings_.width = std::max(16u, settings.width / 2);
    settings_.height = std::max(16u, settings.height / 2);
}

Picked Hand::pick(const ParticleView& view, double time, const FreeCamera& camera, const Eigen::Vector2f& at)
{
    if (!layers_) layers_ = std::make_unique<LayerRenderer>(gpu_, world_, settings_);
    layers_->setCamera(camera.position(), camera.target());
    const Layers layers = layers_->draw(view, time);
    const auto pixel = [](float share, uint32_t count) {
        return std::min(static_cast<uint32_t>(share * static_cast<float>(count)), count - 1);
    };
    const uint32_t column = pixel(at.x(), layers.width), row = pixel(at.y(), layers.height);
    const size_t index = size_t{row} * layers.width + column;
    Picked picked;
    picked.depth = layers.places[index].w;
    if (picked.depth < 0.0f) return picked;
    const double across = (column + 0.5 - 0.5 * layers.width) / layers.camera.focal;
    const double up = (0.5 * layers.height - row - 0.5) / layers.camera.focal;
    const Eigen::Vector3d place = static_cast<double>(picked.depth) * Eigen::Vector3d(across, up, -1.0);
    picked.place = (layers.camera.toWorld * place).cast<float>();
    const PixelIds ids = things_.idsOf(layers.things[index]);
    if (ids.body > 0) {
        picked.body = ids.body - 1;
        picked.name = nameInScene(world_, world_.bodies[picked.body]);
    } else if (ids.object > 0) picked.name = things_.names()[ids.object - 1];
    return picked;
}

void Hand::grab(const Picked& picked, const BodyState& pose)
{
    body_ = picked.body;
    held_ = pose.rotation.conjugate() * (picked.place - pose.position);
    target_ = picked.place;
    depth_ = picked.depth;
    double mass = 0.0;
    for (const Body& body : world_.bodies)
        if (body.assembly == world_.bodies[picked.body].assembly) mass += bodyMass(world_, body).mass;
    strength_ = MOST_WEIGHTS * 9.81f * static_cast<float>(mass);
}

Change Hand::pull(const BodyState& pose) const
{
    const BodyMass mass = bodyMass(world_, world_.bodies[*body_]);
    const Vector3f arm = pose.rotation * held_;
    const Vector3f place = pose.position + arm, velocity = pose.velocity + pose.angularVelocity.cross(arm);
    Vector3f wanted = EAGERNESS * (target_ - place);
    if (wanted.norm() > FASTEST) wanted *= FASTEST / wanted.norm();
    // How a push at the place changes its velocity.
    const Matrix3f turn = pose.rotation.toRotationMatrix();
    const Matrix3f cross{{0, -arm.z(), arm.y()}, {arm.z(), 0, -arm.x()}, {-arm.y(), arm.x(), 0}};
    const Matrix3f yields = Matrix3f::Identity() / static_cast<float>(mass.mass) -
                            cross * turn * mass.inverseInertia.cast<float>() * turn.transpose() * cross;
    Vector3f impulse = yields.inverse() * (wanted - velocity);
    const float most = strength_ * world_.settings.timeStep;
    if (impulse.norm() > most) impulse *= most / impulse.norm();
    return {
        .kind = ChangeKind::Push, .name = nameInScene(world_, world_.bodies[*body_]), .impulse = impulse, .at = place};
}

double Hand::massOf(uint32_t body) const
{
    return bodyMass(world_, world_.bodies[body]).mass;
}

}  // namespace knuckle
