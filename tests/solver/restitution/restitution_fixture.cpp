#include "tests/solver/restitution/restitution_fixture.h"

#include <algorithm>
#include <cmath>

namespace knuckle::test {

namespace {

World bouncyWorld()
{
    World world = worldWithColliders();
    world.materials[0].restitution = 0.5f;  // for the stage to be there; each particle gets its own below
    return world;
}

template <typename Value>
void writeSecondHalf(Buffer<Value>& buffer, const std::vector<Value>& values)
{
    buffer.write(values.data(), values.size() * sizeof(Value), buffer.size() / 2 * sizeof(Value));
}

std::vector<gpu::vec4> readSecondHalf(const Buffer<gpu::vec4>& buffer, size_t count)
{
    std::vector<gpu::vec4> values(count);
    buffer.read(values.data(), count * sizeof(gpu::vec4), buffer.size() / 2 * sizeof(gpu::vec4));
    return values;
}

}  // namespace

RestitutionFixture::RestitutionFixture() : ContactFixture(bouncyWorld())
{
    Random random(201);
    masses_ = stages.particles.masses.download();
    for (gpu::vec4& m : masses_) m.y = std::max(random.between(-0.3f, 1.0f), 0.0f);
    fill(stages.particles.masses, masses_);
    offsets_ = stages.particles.restOffsets.download();
    before = randomVelocities(2, 60, 202);
    solved = randomVelocities(2, 60, 203);
    now = randomVelocities(2, 60, 204);
    ways = randomFields(0.02f, 0.02f, 205);
    for (uint32_t m = 0; m < moverCount(); ++m) {
        splits.push_back(responds(m) ? std::floor(random.between(1, 6)) : 0.0f);
        shares.push_back({random.between(0, 1), random.between(0, 1), 0, 0});
    }
    fill(stages.bodies.oldMoverVelocities, before.fields);
    fill(stages.restitution->moverSolvedVelocities, solved.fields);
    fill(stages.bodies.moverVelocities, now.fields);
    fill(stages.bodies.oldMoverMoves, ways);
    fill(stages.restitution->moverRestitutionSplits, splits);
    fill(stages.restitution->moverRestitutionShares, shares);
    makePairs();
    makeColliderContacts();
    setRestitutions(206);
}

/// A velocity field is the chord of the last substep's turn: the move of the axes, over its time.
Velocities RestitutionFixture::randomVelocities(float ofT, float ofSpin, uint32_t seed) const
{
    Random random(seed);
    Velocities out;
    out.fields.resize(stages.bodies.moverVelocities.size());
    for (uint32_t m = 0; m < moverCount(); ++m) {
        Velocity v;
        const Vector3f t = random.inCube(ofT), spin = random.inCube(ofSpin);
        if (responds(m)) v.t = t.cast<double>();
        out.fields[fieldStart(m)] = packed(Vector3f(v.t.cast<float>()));
        if (isBody(m) && responds(m)) {
            const Vector3d w = spin.cast<double>();
            const double angle = w.norm() * h();
            const Matrix3d axes = rotation(m).toRotationMatrix();
            const Matrix3d back = Eigen::AngleAxisd(-angle, w.normalized()).toRotationMatrix();
            const Matrix3d f = (axes - back * axes) / h();
            for (uint32_t c = 0; c < 3; ++c)
                out.fields[fieldStart(m) + 1 + c] = packed(Vector3f(f.col(c).cast<float>()));
            v.spin = w.normalized() * (2.0 * std::sin(0.5 * angle) / h());
        }
        out.known.push_back(v);
    }
    return out;
}

/// A third carries nothing in the substep; the solver's impulses [kg m] have any direction.
void RestitutionFixture::addState(TestContact& c, Random& random, float levels) const
{
    c.firstArm = isBody(moverOf[c.first]) ? random.inCube(0.1f) : Vector3f(0, 0, 0);
    c.firstMass = responds(moverOf[c.first]) ? random.between(0.5f, 4) : 0.0f;
    c.firstFraction = std::floor(random.between(0.3f, 1.0f) * levels) / levels;
    c.secondFraction = std::floor(random.between(0.3f, 1.0f) * levels) / levels;
    const float kind = random.between(0, 3);
    c.impulse = packed(random.inCube(0.002f), kind < 1   ? 0.0f
                                              : kind < 2 ? float(ABOUT_TO_ACT)
                                                         : random.between(0, 0.002f));
}

void RestitutionFixture::makePairs()
{
    Random random(211);
    const auto count = static_cast<float>(world.particles.size());
    std::vector<TestContact> list;
    while (list.size() < 1501) {
        TestContact c{.first = static_cast<uint32_t>(random.between(0, 0.999f) * count),
                      .second = static_cast<uint32_t>(random.between(0, 0.999f) * count)};
        const uint32_t a = moverOf[c.first], b = moverOf[c.second];
        if (a == b || (isFixed(a) && isFixed(b))) continue;
        addState(c, random, 8191);
        if (isBody(b)) c.secondArm = random.inCube(0.1f);
        c.secondMass = responds(b) ? random.between(0.5f, 4) : 0.0f;
        if (list.size() % 3 == 0) c.hidden = static_cast<uint32_t>(random.between(0, 63.999f));
        list.push_back(c);
    }
    setPairs(std::move(list));
    std::vector<gpu::uvec2> particles;
    for (const TestContact& c : pairs) particles.push_back({c.first, c.second});
    writeSecondHalf(stages.search.pairs, particles);
}

void RestitutionFixture::makeColliderContacts()
{
    Random random(212);
    const auto count = static_cast<float>(world.particles.size());
    std::vector<TestContact> list;
    while (list.size() < 777) {
        TestContact c{.first = static_cast<uint32_t>(random.between(0, 0.999f) * count)};
        c.second = static_cast<uint32_t>(list.size() % 2);
        if (isFixed(moverOf[c.first])) continue;
        addState(c, random, 65535);
        list.push_back(c);
    }
    setColliderContacts(std::move(list));
}

void RestitutionFixture::setRestitutions(uint32_t seed)
{
    Random random(seed);
    const auto some = [&](size_t count) {
        std::vector<gpu::vec4> impulses;
        while (impulses.size() < count) {
            const float kind = random.between(0, 3);
            impulses.push_back(packed(random.inCube(1), kind < 1 ? 0.0f : kind < 2 ? float(ABOUT_TO_ACT) : kind - 2));
        }
        return impulses;
    };
    lastPairs = some(pairs.size());
    lastColliders = some(colliderContacts.size());
    writeSecondHalf(stages.restitution->pairRestitutions, lastPairs);
    writeSecondHalf(stages.restitution->colliderRestitutions, lastColliders);
}

std::vector<gpu::vec4> RestitutionFixture::pairRestitutions() const
{
    return readSecondHalf(stages.restitution->pairRestitutions, pairs.size());
}

std::vector<gpu::vec4> RestitutionFixture::colliderRestitutions() const
{
    return readSecondHalf(stages.restitution->colliderRestitutions, colliderContacts.size());
}

Vector3d RestitutionFixture::particleArm(uint32_t particle) const
{
    return armOf(moverOf[particle], vec3(offsets_[particle]));
}

void RestitutionFixture::addSide(Collision& out, uint32_t mover, const Vector3f& r, double sign, Vector3d& arrival,
                                 Vector3d& way, Vector3d& pull) const
{
    const Vector3d from = armOf(mover, r);
    out.now += sign * out.normal.dot(now.known[mover].at(from));
    out.solved += sign * out.normal.dot(solved.known[mover].at(from));
    // For velocities of some rounded steps each, the angular ones from five of the axes.
    for (const Velocities* v : {&before, &now, &solved})
        out.speedError = std::max(out.speedError, 32 * EPSILON * v->known[mover].size(from));
    if (!responds(mover)) return;
    arrival += sign * before.known[mover].at(from);
    way += sign * field(ways, mover).at(r.cast<double>());
    pull += sign * gravity();
}

/// v^2 = v0^2 + 2 g s, for both along the normal.
void RestitutionFixture::finish(Collision& out, const Vector3d& arrival, const Vector3d& way,
                                const Vector3d& pull) const
{
    const double size = arrival.norm(), speed = -out.normal.dot(arrival);
    out.speedError = 2 * out.speedError + 30.0 * out.turnError;  // no point is faster
    const double square = speed * speed + 2.0 * out.normal.dot(pull) * out.normal.dot(way);
    const double error = 2 * size * out.speedError + 4 * pull.norm() * way.norm() * (out.turnError + 16 * EPSILON);
    out.approach = speed > 0.0 ? std::sqrt(std::max(square, 0.0)) : 0.0;
    out.approachError = speed > 0.0 ? error / std::max(out.approach, 0.03) : 0.0;
    out.sure = out.sure && std::abs(speed) > out.speedError && std::abs(square) > 0.0009;
}

Collision RestitutionFixture::ofPair(const TestContact& c) const
{
    const uint32_t a = moverOf[c.first], b = moverOf[c.second];
    const Vector3d armA = particleArm(c.first), armB = particleArm(c.second);
    const Vector3d apart = centre(a) + armA - centre(b) - armB;
    const auto shown = [&](uint32_t mover, uint32_t hidden) {
        Vector3d v = apart;
        for (int axis = 0; axis < 3; ++axis)
            if (hidden >> axis & 1)
                v -= rotation(mover) * Vector3d::Unit(axis) * v.dot(rotation(mover) * Vector3d::Unit(axis));
        return v;
    };
    const Vector3d byFirst = shown(a, c.hidden & 7), bySecond = shown(b, c.hidden >> 3);
    const bool first = byFirst.norm() < bySecond.norm();
    const double nearest = first ? byFirst.norm() : bySecond.norm(), least = double(LEAST_FLAT * DIAMETER);
    Collision out;
    out.sure = apart.norm() > 0.02 && (c.hidden == 0 || std::abs(nearest - least) > 1e-5) &&
               (c.hidden == 0 || std::abs(byFirst.norm() - bySecond.norm()) > 1e-5 || byFirst.isApprox(bySecond));
    const Vector3d view = nearest > least ? (first ? byFirst : bySecond) : apart;
    out.normal = view.normalized();
    out.turnError = 16 * EPSILON * (apart.norm() + centre(a).norm() + centre(b).norm() + 0.5) / view.norm();
    Vector3d arrival(0, 0, 0), way(0, 0, 0), pull(0, 0, 0);
    addSide(out, a, c.firstArm, 1, arrival, way, pull);
    addSide(out, b, c.secondArm, -1, arrival, way, pull);
    finish(out, arrival, way, pull);
    return out;
}

Collision RestitutionFixture::ofCollider(const TestContact& c) const
{
    const uint32_t m = moverOf[c.first];
    const Collider& collider = world.colliders[c.second];
    const Vector3d from = centre(m) + armOf(m, c.firstArm) - collider.position.cast<double>();
    Collision out;
    out.normal = c.second == 0 ? Vector3d(collider.orientation.cast<double>() * Vector3d::UnitY()) : from.normalized();
    out.turnError = 16 * EPSILON * (1.0 + (c.second == 0 ? 0.0 : 1.0 / from.norm()));
    Vector3d arrival(0, 0, 0), way(0, 0, 0), pull(0, 0, 0);
    addSide(out, m, c.firstArm, 1, arrival, way, pull);
    finish(out, arrival, way, pull);
    return out;
}

Bounce bounceOf(const Collision& c, const gpu::vec4& last, double restitution, double inverseMass, bool eager)
{
    Bounce out;
    out.tolerance = 1e-12;
    out.sure = c.sure;
    if (last.w == 0.0f) return out;
    const double soFar = double(std::max(last.w, 0.0f)), steps = eager ? 1.8 : 1.0;
    const double missing = steps * (restitution * c.approach - c.now) / inverseMass;
    const double whole = std::max(soFar + missing, 0.0);
    const double error = steps * (c.approachError + c.speedError) / inverseMass;
    out.tolerance = error + 16 * EPSILON * (soFar + std::abs(missing)) + c.turnError * std::abs(missing);
    out.sure = c.sure && std::abs(soFar + missing) > out.tolerance;
    out.whole = (whole - soFar) * c.normal;
    out.w = whole > 0.0 ? whole : static_cast<double>(ABOUT_TO_ACT);
    return out;
}

}  // namespace knuckle::test
