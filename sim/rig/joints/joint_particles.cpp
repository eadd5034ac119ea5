#include "sim/rig/joints/joint_particles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/rig/limbs/limb_frame.h"
#include "sim/rig/limbs/seams.h"

namespace knuckle {

namespace {

// Lengths in diameters.
constexpr float SUPPORT = 0.8f;        // a place on a hinge's axis is used if a particle is this near
constexpr float FACING = 1.2f;         // face to face on the lattice
constexpr float NEIGHBOUR = 1.5f;      // further than the lattice's edge neighbours, nearer than its corner ones
constexpr float FLEXION_START = 0.3f;  // the notch of a hinge begins this far behind the axis
constexpr float FLEXION_REACH = 5.0f;  // and ends here, so that it stays at the joint
constexpr size_t LONGEST_HINGE = 5;    // particles
constexpr size_t STIFF_COUNT = 4;
constexpr double KEPT_PART = 0.6;  // a child that would keep less than this is left unchanged

using Particles = std::vector<ParticleDraft>;

bool belongs(const ParticleDraft& particle, uint32_t body)
{
    return std::find(particle.bodies.begin(), particle.bodies.end(), body) != particle.bodies.end();
}

std::vector<uint32_t> particlesOf(const Particles& particles, uint32_t body)
{
    std::vector<uint32_t> found;
    for (uint32_t p = 0; p < particles.size(); ++p) {
        if (belongs(particles[p], body)) {
            found.push_back(p);
        }
    }
    return found;
}

// Particles of one body within `reach` of a free particle of the other.
std::vector<uint32_t> facing(const Particles& particles, uint32_t body, uint32_t other, float reach)
{
    const std::vector<uint32_t> own = particlesOf(particles, body), others = particlesOf(particles, other);
    Vector3f low = Vector3f::Constant(std::numeric_limits<float>::max()), high = -low;
    for (uint32_t p : others) {
        low = low.cwiseMin(particles[p].position);
        high = high.cwiseMax(particles[p].position);
    }
    std::vector<uint32_t> found;
    for (uint32_t p : own) {
        const Vector3f& position = particles[p].position;
        const bool far = ((low - position).array() > reach).any() || ((position - high).array() > reach).any();
        if (particles[p].locked || far) {
            continue;
        }
        if (std::any_of(others.begin(), others.end(), [&](uint32_t q) {
                return !particles[q].locked && (particles[q].position - position).norm() < reach;
            })) {
            found.push_back(p);
        }
    }
    return found;
}

void drop(Particles& particles, const std::vector<uint32_t>& which)
{
    for (uint32_t p : which) {
        particles[p].bodies.clear();
    }
}

bool keepsEnough(const Particles& particles, uint32_t body, size_t dropped)
{
    const double count = static_cast<double>(particlesOf(particles, body).size());
    return count - static_cast<double>(dropped) >= std::max(KEPT_PART * count, 5.0);
}

// Puts a particle at exactly this place, shared by the bodies; their ordinary particles that crowd it give way.
uint32_t place(Particles& particles, const Vector3f& position, std::vector<uint32_t> bodies, float diameter)
{
    float signedDistance = 0.0f, nearest = std::numeric_limits<float>::infinity();
    for (ParticleDraft& particle : particles) {
        const bool ours = std::any_of(bodies.begin(), bodies.end(),
                                      [&](uint32_t body) { return belongs(particle, body); });
        const float distance = (particle.position - position).norm();
        if (ours && distance < nearest) {
            nearest = distance;
            signedDistance = particle.signedDistance;
        }
        if (ours && !particle.locked && distance < CROWDED * diameter) {
            particle.bodies.clear();
        }
    }
    particles.push_back({position, signedDistance, std::move(bodies), true});
    return static_cast<uint32_t>(particles.size() - 1);
}

// Places on the axis, a diameter apart, as many as particles support; at least two.
std::vector<Vector3f> hingePlaces(const Particles& particles, const JointPlan& plan, float diameter)
{
    const auto placesFor = [&](size_t count) {
        std::vector<Vector3f> places;
        for (size_t i = 0; i < count; ++i) {
            const float t = static_cast<float>(i) - 0.5f * static_cast<float>(count - 1);
            places.push_back(plan.anchor + t * diameter * plan.axis);
        }
        return places;
    };
    const auto supported = [&](const Vector3f& position) {
        return std::any_of(particles.begin(), particles.end(), [&](const ParticleDraft& particle) {
            return (belongs(particle, plan.parent) || belongs(particle, plan.child)) &&
                   (particle.position - position).norm() < SUPPORT * diameter;
        });
    };
    for (size_t count = LONGEST_HINGE; count > 2; --count) {
        std::vector<Vector3f> places = placesFor(count);
        if (std::all_of(places.begin(), places.end(), supported)) {
            return places;
        }
    }
    return placesFor(2);
}

// Removes one layer of the child next to the parent, so that a ball joint can swing until the two sides meet.
void clearLayer(Particles& particles, const JointPlan& plan, float diameter)
{
    const std::vector<uint32_t> layer = facing(particles, plan.child, plan.parent, FACING * diameter);
    if (keepsEnough(particles, plan.child, layer.size())) {
        drop(particles, layer);
    }
}

// Cuts a notch of 45 degrees to either side behind a hinge so that it can bend; in front the two sides prevent bending
// back.
void clearNotch(Particles& particles, const JointPlan& plan, float diameter)
{
    for (const uint32_t body : {plan.parent, plan.child}) {
        std::vector<uint32_t> notch;
        for (uint32_t p : particlesOf(particles, body)) {
            const Vector3f offset = particles[p].position - plan.anchor;
            const float behind = offset.dot(plan.flexion), along = std::abs(offset.dot(plan.along));
            if (!particles[p].locked && behind > FLEXION_START * diameter && behind < FLEXION_REACH * diameter &&
                along < behind && std::abs(offset.dot(plan.axis)) < FLEXION_REACH * diameter) {
                notch.push_back(p);
            }
        }
        if (keepsEnough(particles, body, notch.size())) {
            drop(particles, notch);
        }
    }
}

bool collinear(const Particles& particles, const std::vector<uint32_t>& chosen, float diameter)
{
    const Vector3f& a = particles[chosen[0]].position;
    float spread = 0.0f;
    for (uint32_t p : chosen) {
        for (uint32_t q : chosen) {
            spread = std::max(spread, (particles[p].position - a).cross(particles[q].position - a).norm());
        }
    }
    return spread < 0.25f * diameter * diameter;
}

// Four of the particles where the two bodies meet, as far apart from each other as possible.
std::vector<uint32_t> spread(const Particles& particles, const JointPlan& plan, float diameter)
{
    std::vector<uint32_t> candidates = facing(particles, plan.parent, plan.child, NEIGHBOUR * diameter);
    std::vector<uint32_t> chosen;
    while (chosen.size() < STIFF_COUNT && chosen.size() < candidates.size()) {
        float farthest = -1.0f;
        uint32_t best = 0;
        for (uint32_t p : candidates) {
            float distance = chosen.empty() ? (particles[p].position - plan.anchor).norm()
                                            : std::numeric_limits<float>::max();
            for (uint32_t q : chosen) {
                distance = std::min(distance, (particles[p].position - particles[q].position).norm());
            }
            if (distance > farthest) {
                farthest = distance;
                best = p;
            }
        }
        chosen.push_back(best);
    }
    return chosen;
}

std::vector<uint32_t> makeStiff(Particles& particles, const JointPlan& plan, float diameter)
{
    std::vector<uint32_t> chosen = spread(particles, plan, diameter);
    if (chosen.size() == STIFF_COUNT && !collinear(particles, chosen, diameter) &&
        keepsEnough(particles, plan.parent, STIFF_COUNT)) {
        for (uint32_t p : chosen) {
            particles[p].bodies.push_back(plan.child);
            particles[p].locked = true;
        }
        return chosen;
    }
    // The bodies hardly touch: join them by a square of new particles across the joint.
    const Vector3f cross = plan.along.cross(plan.axis);
    chosen.clear();
    for (const auto& [u, v] : {std::pair(-0.5f, -0.5f), {0.5f, -0.5f}, {-0.5f, 0.5f}, {0.5f, 0.5f}}) {
        chosen.push_back(place(particles, plan.anchor + diameter * (u * plan.axis + v * cross),
                               {plan.parent, plan.child}, diameter));
    }
    return chosen;
}

std::vector<uint32_t> makeUniversal(Particles& particles, const JointPlan& plan, float diameter, uint32_t crossBody)
{
    const Vector3f cross = plan.along.cross(plan.axis).normalized();
    // Places the middle particle first: those of both sides must leave room for it.
    const uint32_t middle = place(particles, plan.anchor, {plan.parent, plan.child, crossBody}, diameter);
    particles[middle].bodies = {crossBody};
    std::vector<uint32_t> shared;
    for (const uint32_t body : {plan.parent, plan.child}) {
        for (const float side : {-1.0f, 1.0f}) {
            const Vector3f& axis = body == plan.parent ? plan.axis : cross;
            const uint32_t particle = place(particles, plan.anchor + side * diameter * axis,
                                            {plan.parent, plan.child, crossBody}, diameter);
            particles[particle].bodies = {body, crossBody};
            shared.push_back(particle);
        }
    }
    return shared;
}

}  // namespace

void JointPlan::turnAbout(const Vector3f& other)
{
    axis = other;
    along = perpendicular(along, axis);
    flexion.setZero();
}

std::vector<uint32_t> makeJointParticles(std::vector<ParticleDraft>& particles, const JointPlan& plan, float diameter,
                                         uint32_t crossBody)
{
    std::vector<uint32_t> shared;
    switch (plan.type) {
        case JointType::Stiff: return makeStiff(particles, plan, diameter);
        case JointType::Universal: shared = makeUniversal(particles, plan, diameter, crossBody); break;
        case JointType::Ball: shared = {place(particles, plan.anchor, {plan.parent, plan.child}, diameter)}; break;
        case JointType::Hinge:
            for (const Vector3f& position : hingePlaces(particles, plan, diameter)) {
                shared.push_back(place(particles, position, {plan.parent, plan.child}, diameter));
            }
            break;
    }
    if (plan.clear && plan.type == JointType::Hinge && !plan.flexion.isZero()) {
        clearNotch(particles, plan, diameter);
    } else if (plan.clear) {
        clearLayer(particles, plan, diameter);
    }
    return shared;
}

}  // namespace knuckle
