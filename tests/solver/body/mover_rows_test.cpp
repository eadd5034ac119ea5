#include "tests/solver/body/mover_solve_fixture.h"

namespace knuckle::test {

namespace {

TEST_F(MoverSolve, RowsTurnBodiesByTheirAngularImpulses)
{
    auto& b = fixture.stages.bodies;
    const std::vector<gpu::vec4> angular = randomVectors(rowImpulses.size(), 1e-5f, 118);
    b.rowAngularImpulses = {"rowAngularImpulses", std::span<const gpu::vec4>(angular)};
    solveAll({{"ANGULAR", "1"}});
    const auto ranges = b.bodyRows.download();
    for (uint32_t m = 0; m < fixture.world.bodies.size(); ++m) {
        SCOPED_TRACE("body " + std::to_string(m));
        if (fixture.isFixed(m)) continue;
        Field rows = rowImpulse(m);
        for (uint32_t row = ranges[m].x; row < ranges[m].x + ranges[m].y; ++row) {
            // L is twice the antisymmetric part of p r^T, r in the axes of the world.
            const Vector3d l = vec3(angular[row]).cast<double>();
            Matrix3d cross;
            cross << 0, -l.z(), l.y(), l.z(), 0, -l.x(), -l.y(), l.x(), 0;
            rows.f += 0.5 * cross * fixture.rotation(m).toRotationMatrix();
        }
        const Field whole{sums[m].t + rows.t, sums[m].f + rows.f};
        const double splits = counts[m] / double(wantedRelaxation(m));
        expectMatch(m, whole, sizes[m] + 0.004 * rowCount(m), splits);
    }
}

/// The closed form: an angular impulse alone turns a body by the inverse of its inertia times it, and its centre stays.
TEST_F(MoverSolve, AnAngularImpulseTurnsABodyByItsInertia)
{
    auto& b = fixture.stages.bodies;
    fixture.setPairs({});
    fixture.setColliderContacts({});
    const auto ranges = b.bodyRows.download();
    std::vector<gpu::vec4> rest(predictions.size(), gpu::vec4{}), angular(rowImpulses.size(), gpu::vec4{});
    std::vector<Vector3d> wanted(fixture.world.bodies.size(), Vector3d::Zero());
    Random random(119);
    uint32_t turned = 0;
    for (uint32_t m = 0; m < wanted.size(); ++m) {
        const Matrix3d axes = fixture.rotation(m).toRotationMatrix(), spread = moments(m);
        for (uint32_t c = 0; c < 3; ++c)
            rest[fixture.fieldStart(m) + 1 + c] = packed(Vector3f((axes * spread).col(c).cast<float>()));
        if (fixture.isFixed(m) || ranges[m].y == 0) continue;
        const Matrix3d inertia = axes * (spread.trace() * Matrix3d::Identity() - spread) * axes.transpose();
        wanted[m] = 0.01 * random.direction().cast<double>();
        angular[ranges[m].x] = packed(Vector3f((inertia * wanted[m]).cast<float>()));
        ++turned;
    }
    EXPECT_GT(turned, 4u);
    fill(b.moverPredictions, rest);
    fill(b.rowImpulses, std::vector<gpu::vec4>(rowImpulses.size(), gpu::vec4{}));
    b.rowAngularImpulses = {"rowAngularImpulses", std::span<const gpu::vec4>(angular)};
    solveAll({{"ANGULAR", "1"}});
    const auto turns = b.moverRotationDeltas.download(), moves = b.moverMoves.download();
    for (uint32_t m = 0; m < wanted.size(); ++m) {
        if (wanted[m] == Vector3d::Zero()) continue;
        EXPECT_EQ(vec3(moves[m]), Vector3f::Zero()) << "body " << m;
        // The match is of first order: it errs by the angle squared, and by rounding.
        const Vector3d turn = 2.0 * vec3(turns[m]).cast<double>();
        EXPECT_LT((turn - wanted[m]).norm(), 1e-4 + 1e-5) << "body " << m;
    }
}

}  // namespace

}  // namespace knuckle::test
