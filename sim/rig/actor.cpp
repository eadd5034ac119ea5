#include "sim/rig/actor.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/base/errors.h"
#include "sim/rig/particle_owners.h"

namespace knuckle {

namespace {

/// The lattice layers on both sides of a joint, a diameter apart and 1.41 diagonally, fold into each other when it
/// bends; the next ones, 2 apart, still stop it [diameters].
constexpr float SELF_MARGIN = 0.5f;

/// Per body, the particles that are added with it, in order.
std::vector<std::vector<uint32_t>> particlesAddedWith(const Actor& actor)
{
    const std::vector<uint32_t> owners = particleOwners(actor);
    std::vector<std::vector<uint32_t>> added(actor.bodies.size());
    for (uint32_t b = 0; b < actor.bodies.size(); ++b)
        for (uint32_t particle : actor.bodies[b].particles)
            if (owners[particle] == b) added[b].push_back(particle);
    return added;
}

template <typename T>
void reorder(std::vector<T>& items, const std::vector<uint32_t>& order)
{
    if (items.empty()) return;
    std::vector<T> reordered;
    for (const uint32_t item : order) reordered.push_back(items[item]);
    items = std::move(reordered);
}

}  // namespace

std::vector<uint32_t> particleOwners(const Actor& actor)
{
    std::vector<uint32_t> owners(actor.particles.size(), NO_INDEX);
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        for (uint32_t particle : actor.bodies[b].particles) {
            uint32_t& owner = owners[particle];
            if (owner == NO_INDEX || actor.bodies[b].particles.size() < actor.bodies[owner].particles.size()) {
                owner = b;
            }
        }
    }
    return owners;
}

int32_t parentBody(const Actor& actor, uint32_t body)
{
    const int32_t parent = actor.bodies[body].parent;
    return parent >= 0 && actor.bodies[parent].isCross ? actor.bodies[parent].parent : parent;
}

SurfaceDistance surfaceOf(const Actor& actor, uint32_t particle)
{
    if (actor.signedDistances.empty() || actor.outward.empty()) {
        return {};
    }
    return {actor.signedDistances[particle], actor.outward[particle]};
}

bool touchAtRest(const Actor& actor, uint32_t particle, uint32_t other)
{
    return (actor.particles[particle] - actor.particles[other]).norm() <= (0.99f + SELF_MARGIN) * actor.diameter;
}

bool neverTouch(const Actor& actor, uint32_t body, uint32_t other)
{
    const auto limited = [&](const ActorJoint& joint) {
        const auto parent = static_cast<uint32_t>(parentBody(actor, joint.child));
        return joint.limits.any() &&
               ((joint.child == body && parent == other) || (joint.child == other && parent == body));
    };
    const std::array pair{std::min(body, other), std::max(body, other)};
    return std::ranges::any_of(actor.joints, limited) ||
           std::ranges::find(actor.filtered, pair) != actor.filtered.end();
}

void numberAsAdded(Actor& actor)
{
    std::vector<uint32_t> order, numbers(actor.particles.size(), NO_INDEX);
    for (const std::vector<uint32_t>& added : particlesAddedWith(actor))
        order.insert(order.end(), added.begin(), added.end());
    for (uint32_t i = 0; i < order.size(); ++i) numbers[order[i]] = i;
    reorder(actor.particles, order);
    reorder(actor.signedDistances, order);
    reorder(actor.outward, order);
    for (ActorBody& body : actor.bodies)
        for (uint32_t& particle : body.particles) particle = numbers[particle];
    for (ActorJoint& joint : actor.joints)
        for (uint32_t& particle : joint.sharedParticles) particle = numbers[particle];
}

uint32_t addActor(WorldBuilder& builder, const Actor& actor, uint32_t material, const Pose& pose,
                  const Vector3f& velocity)
{
    const std::vector<std::vector<uint32_t>> added = particlesAddedWith(actor);
    std::vector<uint32_t> particles(actor.particles.size(), NO_INDEX), owners = particles, bodies;
    builder.beginObject(actor.name);
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        std::vector<Vector3f> positions;
        std::vector<SurfaceDistance> surface;
        for (uint32_t particle : added[b]) {
            owners[particle] = b;
            particles[particle] = builder.particleCount() + static_cast<uint32_t>(positions.size());
            positions.push_back(actor.particles[particle]);
            surface.push_back(surfaceOf(actor, particle));
        }
        if (positions.empty()) {
            throw InputError(fmt::format("actor '{}': body '{}' has no particle that it does not share", actor.name,
                                         actor.bodies[b].name));
        }
        bodies.push_back(builder.addBody(actor.bodies[b].name, positions, material, Motion::Dynamic, surface));
    }
    for (uint32_t b = 0; b < actor.bodies.size(); ++b) {
        for (uint32_t particle : actor.bodies[b].particles) {
            if (owners[particle] != b) {
                builder.shareParticle(particles[particle], bodies[b]);
            }
        }
    }
    for (const ActorJoint& joint : actor.joints) {
        // A universal joint consists of its two hinges.
        const JointType type = joint.type == JointType::Universal ? JointType::Hinge : joint.type;
        JointDraft draft{{joint.name, type, bodies[joint.parent], bodies[joint.child]}};
        draft.joint.strength = joint.strength;
        setLimits(draft, joint.limits, joint.axis.normalized());
        builder.describeJoint(std::move(draft));
        if (joint.limits.any()) builder.filterPair(bodies[joint.child], bodies[parentBody(actor, joint.child)]);
    }
    for (const auto& [body, other] : actor.filtered) builder.filterPair(bodies[body], bodies[other]);
    builder.setSelfMargin(SELF_MARGIN);
    for (uint32_t b = 0; b < bodies.size(); ++b)
        if (actor.bodies[b].isCross) builder.markCross(bodies[b]);
    return builder.endObject(pose, velocity);
}

}  // namespace knuckle
