#include "tests/solver/contact/parting_fixture.h"

#include <algorithm>
#include <cmath>

#include "shared/contact_constants.h"
#include "sim/solver/layout/body_mass.h"

namespace knuckle::test {

PartingFixture::PartingFixture() : bodiesOfAssembly_(world.assemblyCount)
{
    for (const Body& body : world.bodies) ++bodiesOfAssembly_[body.assembly];
    setTurnsAndInertias();
}

void PartingFixture::setTurnsAndInertias()
{
    Random random(41);
    std::vector<gpu::vec4> packedTurns;
    for (uint32_t m = 0; m < stages.parameters.moverCount; ++m) {
        turns_.push_back(random.rotation());
        packedTurns.push_back(packed(turns_.back()));
    }
    fill(stages.search.searchRotations, packedTurns);
    std::vector<gpu::vec4> packedInertias;
    for (const Body& body : world.bodies) {
        const BodyMass mass = bodyMass(world, body);
        const double radius = std::max(mass.radius, 0.05);  // of a body of one particle: none
        const auto size = static_cast<float>(1.0 / (mass.mass * radius * radius));
        const Vector3f diagonal = size * Vector3f(1.5f, 1.5f, 1.5f) + random.inCube(0.5f * size);
        const Vector3f other = random.inCube(0.5f * size);  // xy, xz, yz
        packedInertias.push_back(packed(diagonal, static_cast<float>(1.0 / mass.mass)));
        packedInertias.push_back(packed(other));
        Matrix3d inertia = diagonal.cast<double>().asDiagonal();
        inertia(0, 1) = inertia(1, 0) = static_cast<double>(other.x());
        inertia(0, 2) = inertia(2, 0) = static_cast<double>(other.y());
        inertia(1, 2) = inertia(2, 1) = static_cast<double>(other.z());
        inertias_.push_back(inertia);
    }
    fill(stages.bodies.bodyInertias, packedInertias);
}

SideMass PartingFixture::massOf(uint32_t particle, const Vector3f& r, const Vector3d& normal) const
{
    const Particle& p = world.particles[particle];
    if (p.body == NO_INDEX) return {1.0 / static_cast<double>(p.mass), 1.0 / static_cast<double>(p.mass)};
    const double inverseMass = 1.0 / bodyMass(world, world.bodies[p.body]).mass;
    return sideMass(inverseMass, inertias_[p.body], r.cast<double>(),
                    turns_[p.body].conjugate().cast<double>() * normal);
}

WayOut PartingFixture::wayOut(uint32_t i, uint32_t j) const
{
    const uint32_t assembly = world.particles[i].assembly;
    if (assembly != NO_INDEX && assembly == world.particles[j].assembly) return {};
    const auto known = [&](uint32_t particle) {
        const Particle& p = world.particles[particle];
        return p.bodyCount == 1 && !p.surface.outward.isZero();
    };
    const auto outward = [&](uint32_t particle) -> Vector3d {
        if (!known(particle)) return Vector3d::Zero();
        const Particle& p = world.particles[particle];
        return turns_[p.body].cast<double>() * p.surface.outward.cast<double>();
    };
    const double first = std::abs(world.particles[i].surface.distance);
    const double second = std::abs(world.particles[j].surface.distance);
    const bool alike = known(i) && known(j) && std::abs(second - first) < 0.25 * DIAMETER;
    const bool byFirst = known(i) && (!known(j) || second > first);
    const Vector3d away = alike ? Vector3d(outward(j) - outward(i)) : Vector3d(byFirst ? -outward(i) : outward(j));
    if (away.norm() <= 0.3) return {};
    return {away.normalized(), (byFirst ? first : second) >= DIAMETER};
}

Vector3d PartingFixture::shown(uint32_t particle, const Vector3d& towards, uint32_t& hidden, bool& sure) const
{
    const Particle& p = world.particles[particle];
    Vector3d out = towards;
    hidden = 0;
    if (p.bodyCount != 1 || bodiesOfAssembly_.at(p.assembly) > 1) return out;
    for (int axis = 0; axis < 3; ++axis) {
        const Vector3d along = turns_[p.body].cast<double>() * Vector3d::Unit(axis);
        const double t = along.dot(towards);
        sure = sure && std::min(std::abs(t), std::abs(std::abs(t) - BESIDE * DIAMETER)) > DISTANCE_ROUNDING;
        if (std::abs(t) >= BESIDE * DIAMETER || (p.surface.ends >> (2 * axis + (t > 0)) & 1)) continue;
        out -= along * t;
        hidden |= 1u << axis;
    }
    return out;
}

Parting PartingFixture::partingOf(uint32_t i, uint32_t j) const
{
    const WayOut way = wayOut(i, j);
    const Vector3d r = (vec3(found[i]) - vec3(found[j])).cast<double>();
    const double far = r.norm(), facing = r.dot(way.away);
    const bool known = !way.away.isZero();
    Parting out;
    out.sure = std::abs(facing / far) > 1e-4 && std::abs(facing / far - 0.5) > 1e-4;
    uint32_t first = 0, second = 0;
    const Vector3d byFirst = shown(i, -r, first, out.sure), bySecond = shown(j, r, second, out.sure);
    out.hidden = first | second << 3;
    const bool between = known && far < (facing < 0.5 * far ? SUNK : 0.5) * DIAMETER;
    const bool isDeep = known && way.deep && far < DIAMETER;
    out.far = far;
    out.normal = r / far;
    out.oneSided = between || isDeep || facing < 0;
    if (between || isDeep) out.normal = way.away;
    else if (facing < 0) out.normal = (r - 2.0 * facing * way.away) / far;
    else if (out.hidden != 0) {
        const bool ofFirst = byFirst.norm() < bySecond.norm();
        const Vector3d flat = ofFirst ? Vector3d(-byFirst) : bySecond;
        out.sure = out.sure && std::abs(flat.norm() - double(LEAST_FLAT * DIAMETER)) > DISTANCE_ROUNDING;
        if (flat.norm() <= double(LEAST_FLAT * DIAMETER)) return out;
        out.far = flat.norm();
        out.normal = flat / out.far;
    }
    return out;
}

}  // namespace knuckle::test
