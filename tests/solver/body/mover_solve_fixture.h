#pragma once

#include <algorithm>
#include <array>
#include <string>

#include "shared/contact_constants.h"
#include "tests/solver/contact/contact_fixture.h"

namespace knuckle::test {

/// The sums of impulses and the match in the middle of a substep: contacts with impulses in all three lists, joints'
/// impulses, and sums of an iteration before.
class MoverSolve : public testing::Test {
protected:
    MoverSolve()
    {
        fixture.setMoves(0.002f, 0.005f, 3.0f);
        fixture.setAssemblies(0x7fffffffu, 1);
        makeContacts();
        sumContacts();
        makeOldSums();
        Stages& b = fixture.stages;
        predictions = fixture.randomFields(0.01f, 0.0f, 111);
        Random random(112);
        for (uint32_t m = 0; m < fixture.world.bodies.size(); ++m) {
            const Eigen::AngleAxisd turn(random.between(0, 0.05f), random.direction().cast<double>());
            const Matrix3d a = turn.toRotationMatrix() * fixture.rotation(m).toRotationMatrix() * moments(m);
            for (uint32_t c = 0; c < 3; ++c)
                predictions[fixture.fieldStart(m) + 1 + c] = packed(Vector3f(a.col(c).cast<float>()));
        }
        fill(b.bodies.moverPredictions, predictions);
        rowRanges = b.bodies.bodyRows.download();
        rowImpulses = randomVectors(b.bodies.rowImpulses.size(), 0.002f, 113);
        fill(b.bodies.rowImpulses, rowImpulses);
    }
    /// Solves all bodies as if without joints, and loose particles.
    void solveAll(const Defines& defines = {})
    {
        fixture.treatAllAsFree();
        fixture.run("body/impulse_sum", fixture.stages.parameters.bodyCount, defines);
        fixture.run("body/body_solve", fixture.stages.parameters.freeBodyCount, with(defines, "ROWS"));
        fixture.run("body/loose_solve", fixture.moverCount() - fixture.stages.parameters.bodyCount, defines);
    }
    /// Loads bodies with joints, whose predictions are relative to their starts.
    void loadJointed()
    {
        std::vector<gpu::vec4> relative = predictions;
        for (uint32_t m = 0; m < fixture.world.bodies.size(); ++m) {
            const Matrix3d f = fixture.field(predictions, m).f - fixture.rotation(m).toRotationMatrix() * moments(m);
            for (uint32_t c = 0; c < 3; ++c)
                relative[fixture.fieldStart(m) + 1 + c] = packed(Vector3f(f.col(c).cast<float>()));
        }
        fill(fixture.stages.bodies.moverPredictions, relative);
        fixture.run("body/impulse_sum", fixture.stages.parameters.bodyCount);
        fixture.run("body/jointed_solve", fixture.stages.parameters.jointedBodyCount);
    }
    Matrix3d moments(uint32_t m) const
    {
        Matrix3d sum = Matrix3d::Zero();
        for (const Part& part : fixture.parts[m]) sum += part.mass * part.r * part.r.transpose();
        return sum;
    }
    const Part& anyPart(uint32_t m, Random& random) const
    {
        const auto count = static_cast<float>(fixture.parts[m].size());
        return fixture.parts[m][static_cast<size_t>(random.between(0, 0.999f) * count)];
    }
    /// A contact of a particle of the mover, at its place, with an impulse that moves the mover by about a millimetre.
    TestContact anyContact(uint32_t m, Random& random) const
    {
        const Part& part = anyPart(m, random);
        TestContact c{.first = part.particle, .firstArm = part.r.cast<float>()};
        const float kind = random.between(0, 4), mass = static_cast<float>(fixture.masses[m]);
        if (kind > 1) c.impulse.w = ABOUT_TO_ACT;
        if (kind > 2) c.impulse = packed(random.inCube(0.001f * mass), random.between(0.1f, 1));
        return c;
    }
    /// Makes about four contacts on each of two thirds of all movers, with the particles that they own.
    void makeContacts()
    {
        Random random(114);
        std::vector<TestContact> pairs, withColliders;
        const auto owners = static_cast<float>(fixture.moverCount());
        while (pairs.size() < 1501 || withColliders.size() < 777) {
            const auto a = static_cast<uint32_t>(random.between(0, 0.999f) * owners);
            const auto b = static_cast<uint32_t>(random.between(0, 0.999f) * owners);
            if (a == b || a % 3 == 0 || b % 3 == 0) continue;
            TestContact c = anyContact(a, random);
            const TestContact other = anyContact(b, random);
            c.second = other.first;
            c.secondArm = other.firstArm;
            if (fixture.moverOf[c.first] != a || fixture.moverOf[c.second] != b) continue;
            if (pairs.size() < 1501) pairs.push_back(c);
            else withColliders.push_back(c);
        }
        fixture.setPairs(std::move(pairs));
        fixture.setColliderContacts(std::move(withColliders));
    }
    void sumContacts()
    {
        sums.resize(fixture.moverCount());
        sizes.resize(sums.size());
        counts.resize(sums.size());
        const auto add = [&](uint32_t particle, const Vector3f& arm, const gpu::vec4& impulse, double side) {
            const uint32_t m = fixture.moverOf[particle];
            const Vector3d p = vec3(impulse).cast<double>();
            sums[m].add(side * p, arm.cast<double>());
            sizes[m] += p.norm();
            counts[m] += impulse.w != 0.0f;
        };
        for (const TestContact& c : fixture.pairs) {
            add(c.first, c.firstArm, c.impulse, 1);
            add(c.second, c.secondArm, c.impulse, -1);
        }
        for (const TestContact& c : fixture.colliderContacts) add(c.first, c.firstArm, c.impulse, 1);
    }
    /// Sets the sums of the iteration before such that the current change is `ratio` times the previous one.
    void makeOldSums()
    {
        changes = fixture.randomImpulses(0.001f, 115);
        oldSums.resize(changes.size());
        Random random(116);
        const float begin[] = {1.0f, 1.2f, INITIAL_RELAXATION, 3.1f, MOST_RELAXATION};
        for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
            ratios.push_back(std::array{-2.0, -0.95, -0.85, -0.1, 1.0}[m % 5]);
            relaxations.push_back(begin[static_cast<size_t>(random.between(0, 4.99f))]);
            const uint32_t start = fixture.fieldStart(m);
            const Field change = fixture.field(changes, m);
            changes[start].w = relaxations.back();
            oldSums[start] = packed(Vector3f((sums[m].t - ratios[m] * change.t).cast<float>()));
            for (uint32_t c = 0; fixture.isBody(m) && c < 3; ++c)
                oldSums[start + 1 + c] = packed(
                    Vector3f((sums[m].f.col(c) - ratios[m] * change.f.col(c)).cast<float>()));
        }
        fill(fixture.stages.bodies.moverImpulses, oldSums);
        fill(fixture.stages.bodies.moverChanges, changes);
    }
    /// It shrinks if changes alternate and lose less than a tenth, otherwise it grows; it restarts if nothing acts.
    float wantedRelaxation(uint32_t m) const
    {
        if (counts[m] == 0) return INITIAL_RELAXATION;
        if (ratios[m] < -0.9) return std::max(0.8f * relaxations[m], 1.0f);
        return std::min(1.05f * relaxations[m], MOST_RELAXATION);
    }
    /// Checks where the mover goes: by its prediction and the impulses on it, matched to A + p r^T.
    void expectMatch(uint32_t m, const Field& impulse, double size, double splits)
    {
        const Field prediction = fixture.field(predictions, m);
        const gpu::vec4 moved = fixture.stages.bodies.moverMoves.download()[m];
        const Vector3d move = prediction.t + impulse.t / fixture.masses[m];
        const double rounding = EPSILON * (counts[m] + 16) * (prediction.t.norm() + size / fixture.masses[m]);
        EXPECT_LE((vec3(moved).cast<double>() - move).norm(), rounding);
        EXPECT_FLOAT_EQ(moved.w, static_cast<float>(splits));
        if (!fixture.isBody(m)) return;
        const auto turn = quaternion(fixture.stages.bodies.moverRotationDeltas.download()[m]).cast<double>();
        // Single precision gives a rotation to some 1e-6, times a body's ratio of length to width.
        EXPECT_LT(rotationError(turn * fixture.rotation(m), prediction.f + impulse.f, moments(m)), 1e-5);
    }
    Field rowImpulse(uint32_t m)
    {
        Field sum;
        const auto arms = fixture.stages.bodies.rowArms.download();
        for (uint32_t row = rowRange(m).x; row < rowRange(m).x + rowRange(m).y; ++row)
            sum.add(vec3(rowImpulses[row]).cast<double>(), vec3(arms[row]).cast<double>());
        return sum;
    }
    gpu::uvec2 rowRange(uint32_t m) const { return fixture.isBody(m) ? rowRanges[m] : gpu::uvec2{0, 0}; }
    uint32_t rowCount(uint32_t m) const { return rowRange(m).y; }

    ContactFixture fixture;
    std::vector<Field> sums;  ///< Per mover, of its contacts.
    std::vector<double> sizes, ratios;
    std::vector<uint32_t> counts;  ///< Contacts that will act.
    std::vector<float> relaxations;
    std::vector<gpu::uvec2> rowRanges;
    std::vector<gpu::vec4> predictions, rowImpulses, oldSums, changes;
};

}  // namespace knuckle::test
