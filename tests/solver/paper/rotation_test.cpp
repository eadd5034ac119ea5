#include <Eigen/SVD>
#include <cmath>
#include <functional>
#include <numbers>

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

namespace {

constexpr double DEGREE = std::numbers::pi / 180.0;
const Defines NEWTON, HOUSEHOLDER = {{"HOUSEHOLDER", "1"}}, HIGHAM = {{"HIGHAM", "1"}};

/// One body's task: to find the rotation of `a`, from `start` at the beginning of the substep.
struct Case {
    Matrix3d a;
    Quaternionf start;
};

/// A stretch with these eigenvalues along random axes.
Matrix3d stretch(const Vector3d& values, Random& random)
{
    const Matrix3d axes = random.rotation().cast<double>().toRotationMatrix();
    return axes * values.asDiagonal() * axes.transpose();
}

/// A body with this stretch, turned by `degrees` about a random axis since the substep began.
Case turned(const Vector3d& values, double degrees, Random& random)
{
    const Quaternionf start = random.rotation();
    const Eigen::AngleAxisd turn(degrees * DEGREE, random.direction().cast<double>());
    return {(turn * start.cast<double>()).toRotationMatrix() * stretch(values, random), start};
}

struct Nearest {
    Eigen::Quaterniond rotation;
    double gap;  ///< Torque over rotation: s2 + s3 over the size of `a`; s3 < 0 if `a` is mirrored.
};

/// The proper rotation nearest to `a`, by its singular values: independent of one method's 4x4 matrix.
Nearest nearest(const Matrix3d& a)
{
    const Eigen::JacobiSVD<Matrix3d> svd(a, Eigen::ComputeFullU | Eigen::ComputeFullV);
    const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0 ? -1.0 : 1.0;
    const Matrix3d q = svd.matrixU() * Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
    return {Eigen::Quaterniond(q), (svd.singularValues()[1] + sign * svd.singularValues()[2]) / a.norm()};
}

class Rotation : public testing::Test {
protected:
    Rotation() : fixture(mixedWorld(byThePaper())), count(fixture.world.bodies.size())
    {
        // All bodies are cases, including those fixed in the world.
        fill(fixture.stages.bodies.moverStates,
             std::vector<uint32_t>(fixture.stages.bodies.moverStates.size(), MOVER_DYNAMIC));
    }

    /// Runs the kernel with this method on one case per body. @returns each body's final rotation.
    std::vector<Eigen::Quaterniond> solve(const Defines& method, const std::vector<Case>& cases)
    {
        Stages& b = fixture.stages;
        std::vector<gpu::vec4> matrices, starts,
            rotations(b.bodies.moverRotations.size(), packed(Quaternionf::Identity()));
        const std::vector<gpu::vec4> unturned = rotations;
        for (const Case& c : cases) {
            for (int k = 0; k < 3; ++k) matrices.push_back(packed(Vector3f(c.a.col(k).cast<float>())));
            starts.push_back(packed({1, 2, 3}));
            starts.push_back(packed(c.start));
            rotations[starts.size() / 2 - 1] = starts.back();
        }
        fill(b.paper->bodyMatrices, matrices);
        fill(b.paper->bodyStarts, starts);
        fill(b.bodies.moverRotations, rotations);
        fill(b.bodies.moverMoves, std::vector<gpu::vec4>(rotations.size(), packed({0.5f, 0, 0})));
        fill(b.bodies.moverRotationDeltas, unturned);
        fixture.forBodies("paper/body_rotation", method);
        std::vector<Eigen::Quaterniond> found;
        const auto turns = b.bodies.moverRotationDeltas.download(), ends = b.bodies.moverRotations.download();
        const auto centres = b.bodies.moverCentres.download();
        for (size_t k = 0; k < cases.size(); ++k) {
            found.push_back(quaternion(ends[k]).cast<double>());
            EXPECT_EQ(vec3(centres[k]), Vector3f(1.5f, 2, 3)) << "body " << k;
            EXPECT_NEAR(found[k].norm(), 1.0, 1e-6) << "body " << k;
            const Quaternionf composed = quaternion(turns[k]) * cases[k].start;
            EXPECT_LT(composed.cast<double>().angularDistance(found[k]), 2e-6) << "turn of body " << k;
        }
        return found;
    }
    std::vector<Case> cases(const std::function<Case(Random&)>& make)
    {
        Random random(31);
        std::vector<Case> out;
        for (size_t k = 0; k < count; ++k) out.push_back(make(random));
        return out;
    }
    void expectOracle(const Defines& method, const std::vector<Case>& list, double tolerance)
    {
        const auto found = solve(method, list);
        for (size_t k = 0; k < list.size(); ++k)
            EXPECT_LT(found[k].angularDistance(nearest(list[k].a).rotation), tolerance) << "body " << k;
    }
    /// Some eight roundings in the torque of A and as many in the quaternions; in addition, each of the three rounds
    /// leaves of a turn 1e-4 lambda (higham.glsl) over the distance 2 gap to the next eigenvalue.
    void expectHigham(const std::vector<Case>& list)
    {
        const auto found = solve(HIGHAM, list);
        for (size_t k = 0; k < list.size(); ++k) {
            const auto [wanted, gap] = nearest(list[k].a);
            const double left = std::pow(1e-4 / (2 * gap), 3) * std::numbers::pi;
            EXPECT_LT(found[k].angularDistance(wanted), (8 + 8 / gap) * EPSILON + left) << "body " << k;
        }
    }

    KernelFixture fixture;
    size_t count;
};

// Single precision gives a rotation to some 1e-6; the stretches below have gaps of at least a tenth of their size,
// which makes this ten times larger. The Newton steps converge quadratically from a substep's turn.
constexpr double ROUNDING = 1e-5;

TEST_F(Rotation, SolidBodiesTurnAsTheOracleSays)
{
    const auto list = cases([](Random& r) {
        return turned(0.3 * Vector3d(r.between(0.2f, 1), r.between(0.2f, 1), r.between(0.2f, 1)), 20.0, r);
    });
    expectOracle(NEWTON, list, ROUNDING);
}

TEST_F(Rotation, SolidBodiesTurnAsTheOracleSaysByHouseholder)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, 0.1}, r.between(0, 170), r); });
    expectOracle(HOUSEHOLDER, list, ROUNDING);
}

TEST_F(Rotation, BodiesOfAnyShapeTurnByAnyAngleByHigham)
{
    const Vector3d shapes[] = {{0.3, 0.2, 0.1},   {0.2, 0.2, 0.2},     {0.4, 0.1, 0.1},  {0.3, 0.2, 0.0},
                               {0.3, 0.3, 0.001}, {0.3, 0.001, 0.001}, {0.3, 0.001, 0.0}};
    for (const Vector3d& shape : shapes) {
        SCOPED_TRACE(shape.transpose());
        expectHigham(cases([&](Random& r) { return turned(shape, r.between(0, 170), r); }));
    }
}

TEST_F(Rotation, MirroredBodiesHaveTheNearestProperRotationByHigham)
{
    for (const double pressed : {-0.001, -0.05, -0.15}) {
        SCOPED_TRACE(pressed);
        expectHigham(cases([&](Random& r) { return turned({0.3, 0.2, pressed}, r.between(0, 170), r); }));
    }
    // Many rotations are equally near: any proper rotation will do.
    solve(HIGHAM, cases([](Random& r) { return turned({0.2, 0.2, -0.2}, 20.0, r); }));
}

TEST_F(Rotation, ABodyDrawnIntoAPointKeepsItsRotationByHigham)
{
    const auto list = cases([](Random& r) { return Case{Matrix3d::Zero(), r.rotation()}; });
    const auto found = solve(HIGHAM, list);
    for (size_t k = 0; k < list.size(); ++k)
        EXPECT_LT(found[k].angularDistance(list[k].start.cast<double>()), 1e-6) << "body " << k;
}

TEST_F(Rotation, ATurnOfSixtyDegreesIsFollowed)
{
    const auto cube = cases([](Random& r) { return turned({0.2, 0.2, 0.2}, 60.0, r); });
    expectOracle(NEWTON, cube, ROUNDING);
    expectOracle(HOUSEHOLDER, cube, ROUNDING);
    expectOracle(HIGHAM, cube, ROUNDING);
    // A body twice as long as wide; three Newton steps at 60 degrees leave a cubed error of some percent each.
    const auto limb = cases([](Random& r) { return turned({0.4, 0.1, 0.1}, 60.0, r); });
    expectOracle(NEWTON, limb, 1.0 * DEGREE);
    expectOracle(HOUSEHOLDER, limb, ROUNDING);
    expectOracle(HIGHAM, limb, ROUNDING);
}

TEST_F(Rotation, AFlatBodyTurnsAsTheOracleSays)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, 0.0}, 20.0, r); });
    expectOracle(NEWTON, list, ROUNDING);
}

/// A with the paper's virtual particles: adds c (as a share of its size) times the last rotation (eq. 18).
Matrix3d withVirtualParticles(const Case& c, double share)
{
    return c.a + share * c.a.norm() * c.start.cast<double>().toRotationMatrix();
}

TEST_F(Rotation, VirtualParticlesTurnFlatBodiesByHouseholder)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, 0.0}, 20.0, r); });
    const auto found = solve(HOUSEHOLDER, list);
    for (size_t k = 0; k < list.size(); ++k) {
        // The least eigenvalue of A^T A is c^2 of the largest, 1e-4, and rounded by some 2^-24 of it: 1e-3.
        const Matrix3d a = withVirtualParticles(list[k], fixture.stages.parameters.virtualParticles);
        EXPECT_LT(found[k].angularDistance(nearestRotation(a)), 2e-3) << "body " << k;
    }
}

TEST_F(Rotation, VirtualParticlesTurnStraightBodiesByHouseholder)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.0, 0.0}, 20.0, r); });
    const auto found = solve(HOUSEHOLDER, list);
    for (size_t k = 0; k < list.size(); ++k) {
        const Eigen::Quaterniond wanted = nearestRotation(
            withVirtualParticles(list[k], fixture.stages.parameters.virtualParticles));
        // The two small singular values are c and c cos 20 deg: one QR iteration gains the ratio of their squares,
        // 0.88, and 24 leave 0.88^24 = 5 % of the difference.
        const Vector3d line = list[k].a.transpose() * (list[k].a * Vector3d(1, 2, 3));
        EXPECT_LT((found[k] * line - wanted * line).norm() / line.norm(), 0.05) << "body " << k;
        EXPECT_LT(found[k].angularDistance(wanted), 0.05) << "body " << k;
    }
}

TEST_F(Rotation, AStraightBodyFollowsItsLineWithoutTwist)
{
    Random axes(41);
    std::vector<Vector3d> lines;
    const auto list = cases([&](Random& r) {
        const Quaternionf start = r.rotation();
        const Vector3d line = axes.direction().cast<double>();
        lines.push_back(line);
        // Turned perpendicular to the line, so that the way there has no twist.
        const Vector3d now = start.cast<double>() * line;
        const Vector3d across = now.cross(r.direction().cast<double>()).normalized();
        const Vector3d there = Eigen::AngleAxisd(20.0 * DEGREE, across) * now;
        return Case{0.3 * there * line.transpose(), start};
    });
    for (const Defines& method : {NEWTON, HIGHAM}) {
        SCOPED_TRACE(method.empty() ? "NEWTON" : method[0].first);
        const auto found = solve(method, list);
        for (size_t k = 0; k < list.size(); ++k) {
            const Vector3d there = list[k].a * lines[k] / 0.3;
            EXPECT_LT((found[k] * lines[k] - there).norm(), ROUNDING) << "body " << k;
            const auto shortest = Eigen::Quaterniond::FromTwoVectors(list[k].start.cast<double>() * lines[k], there);
            // Each of Newton's three steps turns perpendicular to the line only to first order: some hundredths of the
            // 20 degrees. Higham's lets through the torque's eight roundings over 1e-4: 0.3 degrees in half an angle.
            EXPECT_LT(found[k].angularDistance(shortest * list[k].start.cast<double>()), 0.5 * DEGREE) << "body " << k;
        }
    }
}

TEST_F(Rotation, ABodyThatHasNotTurnedStaysWhereItIs)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, 0.1}, 0.0, r); });
    for (const Defines& method : {NEWTON, HOUSEHOLDER, HIGHAM}) expectOracle(method, list, 2e-6);
}

/// Bodies about as long as wide, thinnest along x, hardly strained: QR, which sorts eigenvalues from large to small, is
/// in the middle of exchanging them.
TEST_F(Rotation, ABodyThatIsThinnestAlongItsFirstAxisTurnsAsTheOracleSays)
{
    double ratio = 1.0;
    const auto list = cases([&](Random& r) {
        const Quaternionf start = r.rotation();
        const Eigen::AngleAxisd turn(1.0 * DEGREE, r.direction().cast<double>());
        ratio += 0.04;
        Matrix3d a = 0.2 * Vector3d(1.0, ratio, 1.1 * ratio).asDiagonal().toDenseMatrix();
        a += 1e-4 * stretch({-0.2, 0.0, 0.2}, r);
        return Case{turn.toRotationMatrix() * start.cast<double>().toRotationMatrix() * a, start};
    });
    expectOracle(NEWTON, list, ROUNDING);
    expectOracle(HOUSEHOLDER, list, ROUNDING);
    expectOracle(HIGHAM, list, ROUNDING);
}

TEST_F(Rotation, AMirroredBodyKeepsItsRotationByHouseholder)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, -0.2}, 20.0, r); });
    const auto found = solve(HOUSEHOLDER, list);
    for (size_t k = 0; k < list.size(); ++k)
        EXPECT_LT(found[k].angularDistance(list[k].start.cast<double>()), 1e-6) << "body " << k;
}

TEST_F(Rotation, ABodyPressedThroughItselfStillHasTheNearestProperRotation)
{
    const auto list = cases([](Random& r) { return turned({0.3, 0.2, -0.05}, 20.0, r); });
    expectOracle(NEWTON, list, ROUNDING);
}

}  // namespace

}  // namespace knuckle::test
