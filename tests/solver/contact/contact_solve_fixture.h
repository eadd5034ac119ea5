#pragma once

#include <algorithm>
#include <cmath>

#include "shared/contact_constants.h"
#include "tests/solver/contact/contact_fixture.h"
#include "tests/solver/contact/contact_reference.h"

namespace knuckle::test {

/// A contact as seen by solveContact (shaders/sim/contact/contact_impulse.glsl), in double precision.
struct Situation {
    Vector3d normal, slide;
    double gap, startGap, leaving;
    bool kin = false;
    double inverseMass, worstMass;
    bool sure = true;
    double places;  ///< Size of the positions whose differences are gap and slide [m]: it determines the rounding.
};

/// A new impulse and its certainty.
struct Answer {
    Vector3d impulse;
    double w, mean;
    double tolerance;
    bool sliding;
    bool onEdge;  ///< So near the limit of a case that rounding decides.
};

class ContactSolve : public testing::Test {
protected:
    static constexpr float SPLITS = 3.0f;

    ContactSolve()
    {
        fixture.setMoves(0.002f, 0.005f, SPLITS);
        fixture.stages.parameters.maxCorrection = 2e-4f;  // some of the depths below are smaller and some are not
        fixture.setParameters();
    }
    const gpu::StepParameters& step() const { return fixture.stages.parameters; }
    /// Contacts act (w != 0) if they were counted; those with a normal part carry a friction of up to it.
    void addImpulse(TestContact& c, Random& random) const
    {
        const float kind = random.between(0, 4), size = 0.005f / (c.firstMass + c.secondMass + 0.01f);
        c.mean = std::max(random.between(-size, size), 0.0f);  // a contact that carries nothing now may have done so
                                                               // lately
        if (kind < 1) return;
        c.impulse = packed(random.inCube(kind < 1.5f ? 0.1f * size : 0.0f), ABOUT_TO_ACT);
        if (kind < 2) return;
        const float normal = random.between(0, size);
        c.impulse = packed(Vector3f(normal * random.direction() + random.inCube(0.3f * size)), normal);
    }
    void addMaterial(TestContact& c, Random& random, float levels) const
    {
        c.firstMass = fixture.isFixed(fixture.moverOf[c.first]) ? 0.0f : random.between(0.5f, 4);
        c.firstFraction = std::floor(random.between(0.3f, 1.0f) * levels) / levels;
        c.secondFraction = std::floor(random.between(0.3f, 1.0f) * levels) / levels;
        c.kineticFriction = std::floor(random.between(0, 4)) / 4;
        c.staticFriction = c.kineticFriction + std::floor(random.between(0, 3)) / 4;
    }
    uint32_t anyParticle(Random& random) const
    {
        const auto count = static_cast<float>(fixture.world.particles.size());
        return static_cast<uint32_t>(random.between(0, 0.999f) * count);
    }
    /// 1501 pairs of particles of different movers, from `deepest` [m] to a centimetre apart; every seventh within one
    /// assembly.
    void makePairs(float deepest = 0.01f)
    {
        Random random(101);
        std::vector<TestContact> list;
        while (list.size() < 1501) {
            TestContact c{.first = anyParticle(random), .second = anyParticle(random)};
            const uint32_t a = fixture.moverOf[c.first], b = fixture.moverOf[c.second];
            if (a == b || (fixture.isFixed(a) && fixture.isFixed(b))) continue;
            addMaterial(c, random, 8191);
            c.secondMass = fixture.isFixed(b) ? 0.0f : random.between(0.5f, 4);
            const Vector3f place = random.inCube(0.3f);
            c.firstArm = fixture.armTo(c.first, place);
            const float far = DIAMETER + random.between(-deepest, 0.01f);
            c.kin = list.size() % 7 == 0;
            c.secondArm = fixture.armTo(c.second, place + far * random.direction());
            if (list.size() % 3 == 0) c.hidden = static_cast<uint32_t>(random.between(0, 63.999f));
            if (ofPair(c).startGap < -static_cast<double>(deepest)) c.hidden = 0;
            addImpulse(c, random);
            list.push_back(c);
        }
        fixture.setPairs(std::move(list));
    }
    /// 777 contacts of movers with the plane and the ball, each of a different particle, at the contact's place.
    void makeColliderContacts()
    {
        Random random(102);
        std::vector<TestContact> list;
        auto offsets = fixture.stages.particles.restOffsets.download();
        ends = fixture.stages.particles.latticeEnds.download();
        while (list.size() < 777) {
            const auto index = static_cast<uint32_t>(list.size());
            TestContact c{.first = index, .second = index % 2};
            addMaterial(c, random, 65535);
            const Collider& collider = fixture.world.colliders[c.second];
            const float off = DIAMETER / 2 + random.between(-0.01f, 0.01f);
            const Vector3f at = random.inCube(0.3f);
            const Vector3f onPlane = collider.orientation * Vector3f(at.x(), off, at.z());
            const Vector3f onBall = collider.position + (collider.radius + off) * random.direction();
            c.firstArm = fixture.armTo(c.first, c.second == 0 ? onPlane : onBall);
            offsets[c.first] = packed(c.firstArm, 1.0f);
            addImpulse(c, random);
            list.push_back(c);
        }
        fill(fixture.stages.particles.restOffsets, offsets);
        fixture.setColliderContacts(std::move(list));
    }
    /// A vector without its parts along the axes of a mover that `hidden` names.
    Vector3d withoutAxes(const Vector3d& v, uint32_t mover, uint32_t hidden) const
    {
        Vector3d out = v;
        for (int axis = 0; axis < 3; ++axis) {
            const Vector3d along = fixture.rotation(mover) * Vector3d::Unit(axis);
            if (hidden >> axis & 1) out -= along * along.dot(v);
        }
        return out;
    }
    /// If a side is near a face or an edge, the distance is measured from that, for the nearer of both, and stays so.
    void flatten(Situation& s, const TestContact& c, const Vector3d& apart) const
    {
        const Vector3d a = withoutAxes(apart, fixture.moverOf[c.first], c.hidden & 7);
        const Vector3d b = withoutAxes(apart, fixture.moverOf[c.second], c.hidden >> 3);
        Vector3d flat = a.norm() < b.norm() ? a : b;
        if (flat.norm() <= double(LEAST_FLAT * DIAMETER)) flat = apart;
        s.normal = flat.normalized();
        s.startGap = flat.norm() - DIAMETER;
        s.gap = s.startGap + s.slide.dot(s.normal);
    }
    Situation ofPair(const TestContact& c) const
    {
        const Vector3d a = fixture.place(c.first, c.firstArm), b = fixture.place(c.second, c.secondArm);
        Situation s;
        const Vector3d first = fixture.moveOfArm(c.first, c.firstArm),
                       second = fixture.moveOfArm(c.second, c.secondArm);
        s.slide = first - second;
        const Vector3d apart = a - b + s.slide;
        s.normal = apart.normalized();
        s.gap = apart.norm() - DIAMETER;
        s.startGap = (a - b).norm() - DIAMETER;
        if (c.hidden != 0) flatten(s, c, a - b);
        s.leaving = std::max(first.dot(s.normal), -second.dot(s.normal));
        s.kin = c.kin;
        s.worstMass = SPLITS * (c.firstMass + c.secondMass);
        s.inverseMass = SPLITS * (c.firstMass * c.firstFraction + c.secondMass * c.secondFraction);
        s.places = 2 * (c.firstArm.norm() + c.secondArm.norm()) + a.norm() + b.norm();
        return s;
    }
    Situation ofCollider(const TestContact& c) const
    {
        const Collider& collider = fixture.world.colliders[c.second];
        const Vector3d up = collider.orientation.cast<double>() * Vector3d::UnitY();
        const Vector3d from = collider.position.cast<double>();
        const auto distance = [&](const Vector3d& x) {
            return c.second == 0 ? up.dot(x) : (x - from).norm() - collider.radius;
        };
        const auto normal = [&](const Vector3d& x) { return c.second == 0 ? up : Vector3d((x - from).normalized()); };
        const uint32_t mover = fixture.moverOf[c.first];
        const Eigen::Quaterniond turned = quaternion(fixture.turns[mover]).cast<double>() * fixture.rotation(mover);
        const auto place = [&](const Vector3d& r) { return Vector3d(fixture.centre(mover) + turned * r); };
        const Vector3d r = c.firstArm.cast<double>();
        const ColliderTouch touch = colliderTouch(ends[c.first], r, turned.conjugate() * normal(place(r)), place,
                                                  distance);
        const Vector3d start = fixture.centre(mover) + fixture.arm(mover, touch.r);
        const Vector3d move = fixture.moveOf(mover, touch.r);
        Situation s;
        s.sure = touch.sure;
        s.normal = normal(start + move);
        s.leaving = move.dot(s.normal);
        s.gap = distance(start + move) - touch.radius;
        s.startGap = distance(start) - touch.radius;
        // Friction acts at the surfaces.
        s.slide = fixture.moveOf(mover, touch.r - touch.radius * (turned.conjugate() * s.normal));
        s.worstMass = SPLITS * c.firstMass;
        s.inverseMass = s.worstMass * c.firstFraction;
        s.places = 2 * c.firstArm.norm() + start.norm() + 2 * from.norm() + 0.5;
        return s;
    }
    /// How far a penetration may be corrected: a bounded share, less if a side is leaving already.
    double recovery(const Situation& s, double depth) const
    {
        const double speed = s.leaving / step().substepTime;
        const double slowed = s.kin ? double(LIMB_RECOVERY)
                                    : std::clamp(1.0 - speed / LEAVING_SPEED, double(LEAST_RECOVERY), 1.0);
        return std::min(step().correction * depth, step().maxCorrection * slowed);
    }
    /// The normal part fades towards its mean, corrects the old penetration by its share, and all that came with this
    /// substep; it may pull if both have sunk. Coulomb's cone about it. Only counted contacts act; the others are
    /// counted when they are about to overlap.
    Answer answer(const TestContact& c, const Situation& s) const
    {
        const double depth = std::max(-s.startGap, 0.0);
        const double allowed = depth - recovery(s, depth);
        const bool sunk = !s.kin && depth > (1 - SUNK) * DIAMETER;
        const bool acts = c.impulse.w != 0.0f && s.worstMass > 0.0;
        const Vector3d old = vec3(c.impulse).cast<double>();
        double last = sunk && c.impulse.w < 0 ? std::min(old.dot(s.normal), 0.0) : std::max(c.impulse.w, 0.0f);
        Answer out;
        if (s.kin) last = std::min(last, std::max(old.dot(s.normal), 0.0));
        const double rate = last < static_cast<double>(c.mean) ? MEAN_FALL * step().meanRate : step().meanRate;
        out.mean = c.mean + rate * (std::max(last, 0.0) - c.mean);
        const double wave = s.kin || last <= 0.0 ? 0.0 : std::min(last - out.mean, SHOCK * out.mean);
        double normal = (s.kin ? double(LIMB_MEMORY) : step().warmStart) * (last - step().impulseDamping * wave);
        Vector3d tangent = old;
        if (acts) {
            normal -= (s.gap + allowed) / s.inverseMass;
            tangent -= s.slide / s.worstMass;
        }
        // Differences of places are off by some 16 roundings; the normal by that over the distance, which mixes normal
        // part and tangent; the rest by some 8 roundings of itself.
        const double error = 16 * EPSILON * s.places, turn = error / (DIAMETER / 2) + 8 * EPSILON;
        const double whole = old.norm() + tangent.norm() + (acts ? (std::abs(s.gap) + depth) / s.inverseMass : 0.0);
        out.tolerance = turn * whole + (acts ? 2 * error / s.inverseMass : 0.0);
        const double most = sunk && acts ? step().maxCorrection / s.inverseMass : 0.0;
        out.onEdge = !s.sure || (std::abs(normal) < out.tolerance && acts);
        out.onEdge |= std::abs(depth - (1 - SUNK) * DIAMETER) < 3 * error;
        normal = std::max(normal, -most);
        const double bound = std::max(normal, SUNK_GRIP * most);
        tangent -= s.normal * s.normal.dot(tangent);
        const double size = tangent.norm();
        out.sliding = size > c.staticFriction * bound;
        out.onEdge |= std::abs(size - c.staticFriction * bound) < 2 * out.tolerance && size > out.tolerance;
        const double speed = (s.slide - s.normal * s.normal.dot(s.slide)).norm() / step().substepTime;
        out.onEdge |= std::abs(speed - STICK_SPEED) * step().substepTime < 3 * error;
        const float friction = speed > STICK_SPEED ? c.kineticFriction : c.staticFriction;
        if (out.sliding) tangent *= friction * bound / size;
        out.impulse = tangent + normal * s.normal;
        const double soon = 2 * s.gap - s.startGap;
        out.onEdge |= normal <= 0.0 && !sunk && std::abs(soon) < 3 * error;
        out.w = normal > 0.0 ? normal : soon < 0.0 || sunk ? double(ABOUT_TO_ACT) : 0.0;
        return out;
    }
    template <typename Situate>
    void expectAnswers(const std::vector<TestContact>& contacts, const std::vector<gpu::vec4>& found,
                       const std::vector<float>& means, Situate situate)
    {
        uint32_t sticking = 0, sliding = 0, released = 0, waiting = 0, soon = 0, edges = 0;
        for (size_t q = 0; q < contacts.size(); ++q) {
            const TestContact& c = contacts[q];
            const Answer a = answer(c, situate(c));
            if (a.onEdge && ++edges) continue;
            ASSERT_NEAR(found[q].w, a.w, a.tolerance) << "contact " << q;
            ASSERT_NEAR(means[q], a.mean, 1e-6 * a.mean + step().meanRate * a.tolerance) << "contact " << q;
            ASSERT_LE((vec3(found[q]).cast<double>() - a.impulse).norm(), 3 * a.tolerance) << "contact " << q;
            if (a.w > 0.0) ++(a.sliding ? sliding : sticking);
            if (a.w <= 0.0 && c.impulse.w > 0.0f) ++released;
            if (a.w == 0.0 && c.impulse.w == 0.0f) ++waiting;
            if (a.w < 0.0) ++soon;
        }
        // Every case occurs more than a few times.
        for (uint32_t met : {sticking, sliding, released, waiting, soon}) EXPECT_GT(met, contacts.size() / 40);
        EXPECT_LT(edges, contacts.size() / 100);
    }

    ContactFixture fixture;
    std::vector<uint32_t> ends;  ///< Per particle: latticeEnds.
};

}  // namespace knuckle::test
