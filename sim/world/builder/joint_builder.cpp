#include "sim/world/builder/joint_builder.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "sim/world/builder/parts/joints.h"

namespace knuckle {

void JointBuilder::addJoint(uint32_t parent, uint32_t child, const JointSpec& spec)
{
    requireObject("addJoint");
    if (parent == child || std::max(parent, child) >= world_.bodies.size())
        throw std::logic_error(fmt::format("joint \"{}\": needs two different bodies that exist", spec.name));
    if (spec.type == JointType::Universal) return addUniversal(parent, child, spec);
    const JointPlaces places = jointPlaces(spec, world_.diameter());
    shareAt(places.shared, parent, child);
    for (const Vector3f& place : places.limits)
        shareParticle(newParticle(place, world_.bodies[parent].material), parent);
    JointDraft draft{{spec.name, spec.type, parent, child}};
    draft.joint.strength = spec.strength;
    draft.joint.drive = spec.drive;
    draft.joint.geared = spec.geared;
    setLimits(draft, spec.limits, spec.type == JointType::Ball ? alongOf(spec) : spec.axis.normalized());
    describeJoint(std::move(draft));
}

void JointBuilder::addUniversal(uint32_t parent, uint32_t child, const JointSpec& spec)
{
    const JointPlaces places = jointPlaces(spec, world_.diameter());
    const uint32_t cross = addBody(spec.name + ".cross", places.middle, world_.bodies[parent].material);
    // All three bodies share a particle where the axes cross: it carries the load, the light cross only the twist.
    shareAt(places.middle, parent, cross);
    shareParticle(bodyParticles_[cross].front(), child);
    shareAt(places.sharedWithParent, parent, cross);
    shareAt(places.sharedWithChild, child, cross);
    markCross(cross);
    JointDraft first{{spec.name + ".cross", JointType::Hinge, parent, cross}};
    JointDraft second{{spec.name, JointType::Hinge, cross, child}};
    first.joint.strength = second.joint.strength = spec.strength;
    first.joint.strength.time = JointStrength().time;  // the cross stays at the parent
    first.joint.drive = second.joint.drive = spec.drive;
    const Vector3f axis = spec.axis.normalized();
    const auto [atParent, atChild] = hingeLimits(spec.limits);
    setLimits(first, atParent, axis);
    setLimits(second, atChild, alongOf(spec).cross(axis));
    describeJoint(std::move(first));
    describeJoint(std::move(second));
}

namespace {

/// Of the mass of a body's particle, in the joint of bodies of different objects.
constexpr float PIN_MASS = 0.01f;

Quaternionf turnFrom(const Body& child, const Body& parent)
{
    return (parent.rotation.conjugate() * child.rotation).normalized();
}

}  // namespace

/// A body's position is its object's origin until build().
void JointBuilder::sharePlaced(uint32_t particle, uint32_t body)
{
    const Body& its = world_.bodies[body];
    shareParticle(particle, body);
    foreignPlaces_[{body, particle}] = its.rotation.conjugate() * (world_.particles[particle].position - its.position);
}

void JointBuilder::describePlaced(uint32_t parent, uint32_t child, const JointSpec& spec, const JointLimits& limits,
                                  const Vector3f& axis)
{
    const Body& its = world_.bodies[child];
    const JointType type = spec.type == JointType::Universal ? JointType::Hinge : spec.type;
    JointDraft draft{{spec.name, type, parent, child}};
    draft.joint.strength = spec.strength;
    draft.joint.drive = spec.drive;
    draft.joint.geared = spec.geared;
    draft.joint.turn = turnFrom(its, world_.bodies[parent]);
    setLimits(draft, limits, axis);
    draft.axis = its.rotation.conjugate() * draft.axis;
    draft.cone = its.rotation.conjugate() * draft.cone;
    describeJoint(std::move(draft));
}

uint32_t JointBuilder::joinPlaced(uint32_t parent, uint32_t child, const JointSpec& spec)
{
    const JointPlaces places = jointPlaces(spec, world_.diameter());
    const bool universal = spec.type == JointType::Universal;
    const uint32_t material = world_.bodies.at(child).material;
    // A pin of the heavier one could outweigh the other body.
    uint32_t lighter = material;
    if (parent != NO_INDEX && particleMass(world_.bodies[parent].material) < particleMass(material))
        lighter = world_.bodies[parent].material;
    beginObject(spec.name);
    const auto firstAdded = static_cast<uint32_t>(world_.bodies.size());
    if (parent == NO_INDEX)
        parent = addBody("world", universal ? places.sharedWithParent : places.shared, material, Motion::Fixed);
    const auto pinsAt = [&](const std::vector<Vector3f>& wanted, uint32_t first, uint32_t second) {
        for (const Vector3f& place : wanted) {
            const auto& own = bodyParticles_[first];
            const auto at = std::ranges::find_if(
                own, [&](uint32_t p) { return (world_.particles[p].position - place).norm() < 1e-6f; });
            const uint32_t pin = first >= firstAdded && at != own.end() ? *at : newParticle(place, lighter);
            if (!universal) world_.particles[pin].mass = PIN_MASS * particleMass(lighter);
            // Pins lie within their bodies, a diameter from some of their particles.
            world_.particles[pin].touchesAssembly = false;
            for (const uint32_t body : {first, second}) sharePlaced(pin, body);
        }
    };
    const Vector3f axis = spec.axis.normalized();
    if (!universal) {
        pinsAt(places.shared, parent, child);
        describePlaced(parent, child, spec, spec.limits, axis);
    } else {
        const uint32_t cross = addBody("cross", places.middle, material);
        pinsAt(places.middle, cross, parent);
        pinsAt(places.middle, cross, child);
        pinsAt(places.sharedWithParent, parent, cross);
        pinsAt(places.sharedWithChild, child, cross);
        markCross(cross);
        const auto [atParent, atChild] = hingeLimits(spec.limits);
        describePlaced(parent, cross, spec, atParent, axis);
        describePlaced(cross, child, spec, atChild, alongOf(spec).cross(axis));
    }
    endObject();
    return parent;
}

void JointBuilder::addGear(const std::string& name, const HingeBodies& first, const HingeBodies& second, float ratio)
{
    for (const uint32_t body : {first.parent, first.child, second.parent, second.child})
        if (body >= world_.bodies.size())
            throw std::logic_error(fmt::format("gear \"{}\": there is no body {}", name, body));
    gears_.push_back({name, first, second, ratio});
}

void JointBuilder::shareParticle(uint32_t particle, uint32_t body)
{
    auto& members = bodyParticles_.at(body);
    if (std::find(members.begin(), members.end(), particle) == members.end()) members.push_back(particle);
}

void JointBuilder::describeJoint(JointDraft draft)
{
    requireObject("describeJoint");
    joints_.push_back(std::move(draft));
}

uint32_t JointBuilder::findOrCreate(const Vector3f& position, uint32_t bodyA, uint32_t bodyB)
{
    // Just under half a diameter, so that a place midway between two lattice points gets its own particle.
    float nearest = 0.49f * world_.diameter();
    uint32_t found = NO_INDEX;
    for (uint32_t body : {bodyA, bodyB})
        for (uint32_t particle : bodyParticles_[body]) {
            const float distance = (world_.particles[particle].position - position).norm();
            if (distance < nearest) {
                nearest = distance;
                found = particle;
            }
        }
    return found != NO_INDEX ? found : newParticle(position, world_.bodies[bodyA].material);
}

void JointBuilder::shareAt(std::span<const Vector3f> places, uint32_t bodyA, uint32_t bodyB)
{
    for (const Vector3f& place : places) {
        const uint32_t particle = findOrCreate(place, bodyA, bodyB);
        shareParticle(particle, bodyA);
        shareParticle(particle, bodyB);
    }
}

}  // namespace knuckle
