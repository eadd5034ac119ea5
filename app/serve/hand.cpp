#include "app/serve/hand.h"

#include <algorithm>
#include <cmath>

#include "app/scene/joints/scene_joints.h"
#include "app/scene/names/named.h"
#include "sim/solver/edit/clump.h"
#include "sim/solver/layout/body_mass.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;

constexpr float EAGERNESS = 8.0f;                                // how fast it comes to the mouse [1/s]
constexpr float FASTEST = 10.0f;                                 // [m/s]
constexpr float SPOT = 1.5f, MOST_SPOT = 20.0f, HANDFUL = 4.0f;  // radii of what is held [distances of particles]
constexpr double LEAST_SPOT = 0.1;                               // of the mass of what hangs together

float weightOf(double mass)
{
    return Hand::MOST_WEIGHTS * 9.81f * static_cast<float>(mass);
}

Vector3f bounded(const Vector3f& v, float most)
{
    return v.norm() > most ? Vector3f(v * (most / v.norm())) : v;
}

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
    if (const std::optional<Named> loose = looseNamed(world_, picked.name); loose && picked.body == NO_INDEX) {
        picked.firstLoose = loose->first;
        picked.endLoose = loose->end;
    }
    return picked;
}

void Hand::grab(const Picked& picked, Solver& solver)
{
    Held held{.picked = picked, .place = picked.place, .depth = picked.depth};
    if (picked.body != NO_INDEX) {
        const BodyState pose = solver.readBodies().at(picked.body);
        held.place = pose.rotation.conjugate() * (picked.place - pose.position);
        double mass = 0.0;
        for (const Body& body : world_.bodies)
            if (body.assembly == world_.bodies[picked.body].assembly) mass += bodyMass(world_, body).mass;
        held.strength = weightOf(mass);
    } else holdLoose(held, solver.readParticles());
    target_ = picked.place;
    held_ = held;
}

/// Cloth, ropes and soft bodies hang together, and are held at a spot; fluids and grains by the handful.
void Hand::holdLoose(Held& held, const ParticleState& state) const
{
    const uint32_t first = held.picked.firstLoose, end = held.picked.endLoose;
    const auto distance = [&](uint32_t i) { return (state.positions[i] - held.place).squaredNorm(); };
    uint32_t nearest = first;
    for (uint32_t i = first; i < end; ++i)
        if (distance(i) < distance(nearest)) nearest = i;
    const uint32_t assembly = world_.particles[nearest].assembly;
    const bool isFluid = nearest >= world_.solidCount();
    const float apart = isFluid ? world_.fluidSpacing : world_.diameter();
    held.radius = HANDFUL * apart;
    if (isFluid || assembly == NO_INDEX) return;
    double mass = static_cast<double>(world_.particles[nearest].mass);
    bool isAlone = true;
    for (uint32_t i = first; i < end; ++i) {
        if (i == nearest || world_.particles[i].assembly != assembly) continue;
        mass += static_cast<double>(world_.particles[i].mass);
        isAlone = false;
    }
    if (isAlone) return;
    held.strength = weightOf(mass);
    held.particle = nearest;
    held.place = state.positions[nearest];
    held.radius = SPOT * apart;
    // A spot that is too light tugs at the rest in vain.
    while (static_cast<double>(clumpOf(held, state).mass) < LEAST_SPOT * mass && held.radius < MOST_SPOT * apart)
        held.radius *= 1.25f;
}

/// What it holds, at its place.
Clump Hand::clumpOf(const Held& held, const ParticleState& state) const
{
    return clumpAround(world_, held.picked.firstLoose, held.picked.endLoose, held.place, held.radius,
                       [&](uint32_t i) -> std::optional<Vector3f> {
                           if (state.inactive[i]) return {};
                           return state.positions[i];
                       });
}

Vector3f Hand::wanted(const Vector3f& place) const
{
    const Vector3f velocity = EAGERNESS * (target_ - place);
    return velocity * std::min(1.0f, FASTEST / std::max(velocity.norm(), 1e-6f));
}

std::optional<Change> Hand::pull(Solver& solver)
{
    if (held_->picked.body != NO_INDEX) return pullBody(solver.readBodies().at(held_->picked.body));
    return pullLoose(solver.readParticles());
}

Change Hand::pullBody(const BodyState& pose) const
{
    const Body& body = world_.bodies[held_->picked.body];
    const BodyMass mass = bodyMass(world_, body);
    const Vector3f arm = pose.rotation * held_->place;
    const Vector3f place = pose.position + arm, velocity = pose.velocity + pose.angularVelocity.cross(arm);
    // How a push at the place changes its velocity.
    const Matrix3f turn = pose.rotation.toRotationMatrix();
    const Matrix3f cross{{0, -arm.z(), arm.y()}, {arm.z(), 0, -arm.x()}, {-arm.y(), arm.x(), 0}};
    const Matrix3f yields = Matrix3f::Identity() / static_cast<float>(mass.mass) -
                            cross * turn * mass.inverseInertia.cast<float>() * turn.transpose() * cross;
    const Vector3f impulse = yields.inverse() * (wanted(place) - velocity);
    return {.kind = ChangeKind::Push,
            .name = nameInScene(world_, body),
            .impulse = bounded(impulse, held_->strength * world_.settings.timeStep),
            .at = place};
}

std::optional<Change> Hand::pullLoose(const ParticleState& state)
{
    Held& held = *held_;
    if (held.particle != NO_INDEX) held.place = state.positions[held.particle];
    const Clump clump = clumpOf(held, state);
    if (clump.empty()) return {};
    Vector3f place(0, 0, 0), velocity(0, 0, 0);
    for (const auto& [i, share] : clump.shares) {
        const float part = share * world_.particles[i].mass / clump.mass;
        place += part * state.positions[i];
        velocity += part * state.velocities[i];
    }
    const float step = world_.settings.timeStep;
    const float strength = held.strength > 0.0f ? held.strength : weightOf(static_cast<double>(clump.mass));
    const Vector3f impulse = bounded(Vector3f(clump.mass * (wanted(place) - velocity)), strength * step);
    const Change change{.kind = ChangeKind::Stir,
                        .name = held.picked.name,
                        .impulse = impulse,
                        .at = held.place,
                        .radius = held.radius};
    // A handful moves on with what is in it.
    held.place = place + step * (velocity + impulse / clump.mass);
    return change;
}

double Hand::massOf(uint32_t body) const
{
    return bodyMass(world_, world_.bodies[body]).mass;
}

}  // namespace knuckle
