#include "sim/solver/measure/measure.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/world/collider_distance.h"
#include "sim/world/matter/grain.h"
#include "sim/world/space/cells.h"

namespace knuckle {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

bool inBody(const World& world, uint32_t particle, uint32_t bodyIndex)
{
    const Body& body = world.bodies[bodyIndex];
    for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
        if (world.links[l].particle == particle) return true;
    return false;
}

struct Depths {
    uint32_t count = 0;
    double sum = 0.0;
    float worst = 0.0f;
    void add(float depth)
    {
        ++count;
        sum += depth;
        worst = std::max(worst, depth);
    }
    float mean() const { return count > 0 ? static_cast<float>(sum / count) : 0.0f; }
};

Depths penetrations(const World& world, const std::vector<Collider>& colliders, const std::vector<Vector3f>& positions)
{
    Depths depths;
    const auto radius = [&](uint32_t i) { return world.particles[i].scale * world.particleRadius; };
    // Fluids have no contacts.
    Cells cells(largestScale(world) * world.diameter());
    for (uint32_t i = 0; i < world.solidCount(); ++i) cells.add(positions[i], i);
    for (const auto& [cell, members] : cells.members())
        for (int k = 0; k < 27; ++k) {
            const auto* others = cells.around(cell, k);
            if (!others) continue;
            for (uint32_t i : members)
                for (uint32_t j : *others) {
                    if (j <= i) continue;
                    const float depth = radius(i) + radius(j) - (positions[i] - positions[j]).norm();
                    if (depth > 0.0f && mayTouch(world, i, j)) depths.add(depth);
                }
        }
    for (uint32_t i = 0; i < world.solidCount(); ++i) {
        if (isFixedForEver(world, world.particles[i])) continue;
        for (const Collider& collider : colliders) {
            const float depth = radius(i) - colliderDistance(world, collider, positions[i]);
            if (depth > 0.0f) depths.add(depth);
        }
    }
    return depths;
}

Vector3f goalOf(const Link& link, const BodyState& state)
{
    return state.position + state.rotation * link.restOffset;
}

/// Of joints between some bodies.
Depths jointGaps(const World& world, const ParticleState& particles, const std::vector<BodyState>& bodies,
                 uint32_t firstBody, uint32_t bodyEnd)
{
    Depths gaps;
    std::map<uint32_t, std::vector<Vector3f>> places;
    for (const Link& link : world.links)
        if (link.body >= firstBody && link.body < bodyEnd && world.particles[link.particle].bodyCount > 1 &&
            !particles.lost(world, link))
            places[link.particle].push_back(goalOf(link, bodies[link.body]));
    for (const auto& [particle, wanted] : places) {
        float gap = 0.0f;
        for (size_t a = 0; a < wanted.size(); ++a)
            for (size_t b = a + 1; b < wanted.size(); ++b) gap = std::max(gap, (wanted[a] - wanted[b]).norm());
        gaps.add(gap);
    }
    return gaps;
}

/// Largest distance of a body's particle from its place in the best rigid fit to all of them; shared ones left out.
float worstShapeError(const World& world, const ParticleState& particles)
{
    double worst = 0.0;
    for (const Body& body : world.bodies) {
        Eigen::Matrix3Xd rest(3, body.linkCount), now(3, body.linkCount);
        Eigen::Index own = 0;
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l) {
            const Link& link = world.links[l];
            if (world.particles[link.particle].bodyCount > 1) continue;
            rest.col(own) = link.restOffset.cast<double>();
            now.col(own++) = particles.positions[link.particle].cast<double>();
        }
        if (own < 2) continue;
        const Eigen::Matrix4d fit = Eigen::umeyama(rest.leftCols(own), now.leftCols(own), false);
        const Eigen::Vector3d shift = fit.topRightCorner<3, 1>();
        const Eigen::Matrix3Xd moved = (fit.topLeftCorner<3, 3>() * rest.leftCols(own)).colwise() + shift;
        worst = std::max(worst, (moved - now.leftCols(own)).colwise().norm().maxCoeff());
    }
    return static_cast<float>(worst);
}

}  // namespace

bool mayTouch(const World& world, uint32_t a, uint32_t b)
{
    const Particle& first = world.particles[a];
    const Particle& second = world.particles[b];
    if (first.assembly != second.assembly || first.assembly == NO_INDEX) return true;
    if (first.body == second.body && first.body != NO_INDEX) return false;
    if (!first.touchesAssembly || !second.touchesAssembly) return false;
    const float near = 0.99f + std::max(first.selfMargin, second.selfMargin);
    if ((first.restPosition - second.restPosition).norm() <= near * world.diameter()) return false;
    if (first.body == NO_INDEX || second.body == NO_INDEX) return true;
    if (first.bodyCount < 2 && second.bodyCount < 2) return !areFiltered(world, first.body, second.body);
    for (uint32_t body = 0; body < world.bodies.size(); ++body) {
        if (world.bodies[body].assembly != first.assembly) continue;
        const bool hasFirst = inBody(world, a, body), hasSecond = inBody(world, b, body);
        if (hasFirst && hasSecond) return false;
        for (const uint32_t other : world.bodies[body].filtered)
            if ((hasFirst && inBody(world, b, other)) || (hasSecond && inBody(world, a, other))) return false;
    }
    return true;
}

BodyState bodyState(const World& world, const Body& body, const ParticleState& particles, const Vector3f& centre,
                    const Quaternionf& rotation)
{
    BodyState state;
    state.rotation = rotation;
    state.position = centre;
    if (neverResponds(body)) return state;
    Vector3d momentum = Vector3d::Zero(), offset = Vector3d::Zero();
    double mass = 0.0;
    const auto eachLink = [&](const auto& visit) {
        for (uint32_t l = body.linkStart; l < body.linkStart + body.linkCount; ++l)
            if (!particles.lost(world, world.links[l])) visit(world.links[l]);
    };
    eachLink([&](const Link& link) {
        momentum += link.mass * particles.velocities[link.particle].cast<double>();
        offset += link.mass * (rotation * link.restOffset).cast<double>();
        mass += link.mass;
    });
    if (mass == 0.0) return state;  // torn joints took all its particles
    const Vector3d mean = momentum / mass, middle = offset / mass;
    // The angular velocity of the rigid body's velocity field through the particles that it has.
    Vector3d angular = Vector3d::Zero();
    Matrix3d inertia = Matrix3d::Zero();
    eachLink([&](const Link& link) {
        const Vector3d r = (rotation * link.restOffset).cast<double>() - middle;
        angular += link.mass * r.cross(particles.velocities[link.particle].cast<double>() - mean);
        inertia += link.mass * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
    });
    inertia += 1e-9 * (inertia.trace() + 1e-30) * Matrix3d::Identity();
    const Vector3d spin = inertia.ldlt().solve(angular);
    state.angularVelocity = spin.cast<float>();
    state.velocity = (mean - spin.cross(middle)).cast<float>();
    return state;
}

float worstJointGap(const World& world, const ParticleState& particles, const std::vector<BodyState>& bodies,
                    const Object& object)
{
    return jointGaps(world, particles, bodies, object.bodyStart, object.bodyStart + object.bodyCount).worst;
}

Measures measureState(const World& world, const std::vector<Collider>& colliders, const ParticleState& particles,
                      const std::vector<BodyState>& bodies)
{
    Measures m;
    const Depths depths = penetrations(world, colliders, particles.positions);
    const Depths gaps = jointGaps(world, particles, bodies, 0, static_cast<uint32_t>(world.bodies.size()));
    m.contactCount = depths.count;
    m.meanPenetration = depths.mean();
    m.worstPenetration = depths.worst;
    m.worstShapeError = worstShapeError(world, particles);
    m.meanJointGap = gaps.mean();
    m.worstJointGap = gaps.worst;
    measureSoftBodies(m, world, particles);
    for (size_t i = 0; i < particles.velocities.size(); ++i) {
        const float speed = particles.velocities[i].norm();
        m.maxSpeed = std::max(m.maxSpeed, speed);
        m.kineticEnergy += 0.5 * world.particles[i].mass * speed * speed;
    }
    return m;
}

}  // namespace knuckle
