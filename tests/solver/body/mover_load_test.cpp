#include <Eigen/Eigenvalues>

#include "shared/joint_records.h"
#include "tests/solver/body/mover_solve_fixture.h"

namespace knuckle::test {

namespace {

/// Bodies with joints do not move by themselves: their loads go to their tree.
class MoverLoad : public MoverSolve {
protected:
    struct Load {
        Vector3d force, torque;
        Matrix3d hessian;
    };
    Load load(uint32_t body)
    {
        const auto texels = fixture.stages.bodies.bodyLoads.download();
        const gpu::vec4 *t = &texels[BODY_LOAD_TEXELS * body], &a = t[2], &b = t[3];
        Matrix3d hessian;
        hessian << a.x, a.w, b.x, a.w, a.y, b.y, b.x, b.y, a.z;
        return {vec3(t[0]).cast<double>(), vec3(t[1]).cast<double>(), hessian};
    }
    bool isJointed(uint32_t m) const { return rowRange(m).y > 0; }
    Matrix3d rotationNow(uint32_t m) const
    {
        return (quaternion(fixture.turns[m]).cast<double>() * fixture.rotation(m)).toRotationMatrix();
    }
};

TEST_F(MoverLoad, IsWhatABodyWouldStillHaveToGo)
{
    loadJointed();
    for (uint32_t m = 0; m < fixture.world.bodies.size(); ++m) {
        if (!isJointed(m) || fixture.isFixed(m)) continue;
        const Field rows = rowImpulse(m), prediction = fixture.field(predictions, m);
        const Vector3d shift = vec3(fixture.moves[m]).cast<double>();
        const Vector3d force = fixture.masses[m] * (prediction.t - shift) + sums[m].t + rows.t;
        const Matrix3d r = rotationNow(m), a = prediction.f + sums[m].f + rows.f;
        Vector3d torque = Vector3d::Zero();
        for (int c = 0; c < 3; ++c) torque += r.col(c).cross(a.col(c));
        // Contacts do not turn with the body.
        const Matrix3d g = (prediction.f + rows.f) * r.transpose(), s = 0.5 * (g + g.transpose());
        const Load found = load(m);
        // The sum of counts[m] contacts, and some 32 operations with sums of sizes [kg m] and [kg m2].
        const double rounding = EPSILON * (counts[m] + 32);
        const double size = fixture.masses[m] * (prediction.t.norm() + shift.norm()) + sizes[m] + 0.004 * rowCount(m);
        EXPECT_LE((found.force - force).norm(), rounding * size) << "body " << m;
        EXPECT_LE((found.torque - torque).norm(), 2 * rounding * a.norm()) << "body " << m;
        // Small parts keep bodies regular that nothing can turn.
        const double least = 1e-5 * DIAMETER * DIAMETER * fixture.masses[m];
        const Matrix3d hessian = ((1 + 1e-5) * s.trace() + least) * Matrix3d::Identity() - s;
        EXPECT_LE((found.hessian - hessian).norm(), 4 * rounding * a.norm()) << "body " << m;
    }
}

TEST_F(MoverLoad, LeavesJointedBodiesWhereTheyAre)
{
    loadJointed();
    const auto moves = fixture.stages.bodies.moverMoves.download();
    const auto turns = fixture.stages.bodies.moverRotationDeltas.download();
    uint32_t jointed = 0;
    for (uint32_t m = 0; m < fixture.moverCount(); ++m) {
        if (fixture.isFixed(m) || !isJointed(m)) continue;
        SCOPED_TRACE("mover " + std::to_string(m));
        EXPECT_EQ(vec3(moves[m]), vec3(fixture.moves[m]));
        EXPECT_EQ(vec3(turns[m]), vec3(fixture.turns[m]));
        EXPECT_FLOAT_EQ(moves[m].w, static_cast<float>(counts[m] / double(wantedRelaxation(m))));
        ++jointed;
    }
    EXPECT_GT(jointed, 10u);
}

TEST_F(MoverLoad, ABodyIsNeverEasierToTurnForWhatPressesIt)
{
    for (gpu::vec4& row : rowImpulses) {
        row.x *= 3000;
        row.y *= 3000;
        row.z *= 3000;
    }
    fill(fixture.stages.bodies.rowImpulses, rowImpulses);
    loadJointed();
    uint32_t pressed = 0;
    for (uint32_t m = 0; m < fixture.world.bodies.size(); ++m) {
        if (!isJointed(m) || fixture.isFixed(m)) continue;
        const Matrix3d r = rotationNow(m), a = fixture.field(predictions, m).f + rowImpulse(m).f;
        const Matrix3d g = a * r.transpose(), s = 0.5 * (g + g.transpose());
        const auto least = [](const Matrix3d& h) {
            return Eigen::SelfAdjointEigenSolver<Matrix3d>(h).eigenvalues()[0];
        };
        pressed += least(s.trace() * Matrix3d::Identity() - s) < 0.0;
        EXPECT_GT(least(load(m).hessian), 0.0) << "body " << m;
    }
    EXPECT_GT(pressed, 2u) << "would turn over";
}

}  // namespace

}  // namespace knuckle::test
