#include "tests/solver/joint/joint_fixture.h"

#include <Eigen/Dense>
#include <algorithm>

namespace knuckle::test {

namespace {

Matrix3d crossMatrix(const Vector3d& v)
{
    Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

uint32_t rowsOf(uint32_t freedom)
{
    return freedom == JOINT_NONE ? 0 : freedom == JOINT_BALL ? 3 : freedom == JOINT_HINGE ? 5 : 6;
}

}  // namespace

JointFixture::JointFixture(World worldIn) : MoverFixture(std::move(worldIn))
{
    Random random(121);
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        if (isFixed(b)) {
            centres[b] = packed(world.bodies[b].position);
            rotations[b] = packed(world.bodies[b].rotation);
            continue;
        }
        const Quaternionf turn(Eigen::AngleAxisf(random.between(0, 0.05f), random.direction()));
        centres[b] = packed(Vector3f(world.bodies[b].position + random.inCube(0.01f)));
        rotations[b] = packed(Quaternionf(turn * world.bodies[b].rotation));
    }
    fill(stages.bodies.moverCentres, centres);
    fill(stages.bodies.moverRotations, rotations);
    setMoves(0.003f, 0.02f, 1.0f);
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        if (!isFixed(b)) continue;
        moves[b] = {0, 0, 0, 0};
        turns[b] = {0, 0, 0, 1};
    }
    fill(stages.bodies.moverMoves, moves);
    fill(stages.bodies.moverRotationDeltas, turns);
    uploadLoads();
    rows = randomVectors(stages.bodies.rowImpulses.size(), 0.1f, 122);
    angularRows = randomVectors(stages.bodies.rowAngularImpulses.size(), 0.01f, 123);
    fill(stages.bodies.rowImpulses, rows);
    fill(stages.bodies.rowAngularImpulses, angularRows);
}

void JointFixture::uploadLoads()
{
    Random random(124);
    std::vector<gpu::vec4> loads;
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        const Vector3f force = static_cast<float>(masses[b]) * random.inCube(0.01f);
        const Vector3f torque = static_cast<float>(masses[b]) * random.inCube(0.001f);
        const Matrix3d axes = rotationNow(b).toRotationMatrix();
        Matrix3d spread = Matrix3d::Zero();
        for (const Part& part : parts[b]) spread += part.mass * part.r * part.r.transpose();
        // Something pulls at it, which makes it harder to turn.
        spread += 0.2 * spread.trace() * Matrix3d::Identity();
        const Matrix3d hessian = axes * (spread.trace() * Matrix3d::Identity() - spread) * axes.transpose();
        const Eigen::Matrix3f h = hessian.cast<float>();
        loads.insert(loads.end(), {packed(force), packed(torque), gpu::vec4{h(0, 0), h(1, 1), h(2, 2), h(0, 1)},
                                   gpu::vec4{h(0, 2), h(1, 2), 0, 0}});
        hessians.push_back(hessian);
        forces.emplace_back();
        forces.back() << force.cast<double>(), torque.cast<double>();
    }
    fill(stages.bodies.bodyLoads, loads);
}

Vector3d JointFixture::armNow(uint32_t body, const Vector3f& arm) const
{
    return rotationNow(body) * arm.cast<double>();
}

JointFixture::Vector6d JointFixture::error(const JointTrees::Joint& joint, bool atStart) const
{
    struct Side {
        Vector3d place;
        Eigen::Quaterniond frame;
    };
    const auto side = [&](uint32_t body, const Vector3f& arm, const Quaternionf& frame) {
        const Eigen::Quaterniond q = atStart ? rotation(body) : rotationNow(body);
        const Vector3d move = atStart ? Vector3d(0, 0, 0) : Vector3d(vec3(moves[body]).cast<double>());
        return Side{centre(body) + move + q * arm.cast<double>(), q * frame.cast<double>()};
    };
    const Side own = side(joint.body, joint.side.arm, joint.side.frame);
    const Side parent = side(joint.parent, joint.parentSide.arm, joint.parentSide.frame);
    Vector6d e = Vector6d::Zero();
    e.head<3>() = own.place - parent.place;
    if (joint.freedom == JOINT_HINGE)
        e.tail<3>() = (parent.frame * Vector3d::UnitX()).cross(own.frame * Vector3d::UnitX());
    if (joint.freedom == JOINT_STIFF) {
        const Eigen::Quaterniond turn = own.frame * parent.frame.conjugate();
        e.tail<3>() = (turn.w() < 0 ? -2 : 2) * turn.vec();
    }
    return e;
}

JointFixture::Vector6d JointFixture::left(const JointTrees::Joint& joint) const
{
    const double h = stages.parameters.substepTime;
    Vector6d e = error(joint, true);
    // Half of it, at most at 1 m/s and 20 rad/s.
    e.head<3>() *= 1 - std::min(0.5, h / std::max(e.head<3>().norm(), 1e-20));
    e.tail<3>() *= 1 - std::min(0.5, 20 * h / std::max(e.tail<3>().norm(), 1e-20));
    return e;
}

Eigen::MatrixXd JointFixture::system(std::vector<uint32_t>& firstRow) const
{
    auto size = static_cast<uint32_t>(6 * world.bodies.size());
    const uint32_t unknowns = size;
    const auto joints = trees().all();
    for (const JointTrees::Joint& joint : joints) {
        firstRow.push_back(size);
        size += rowsOf(joint.freedom);
    }
    Eigen::MatrixXd k = Eigen::MatrixXd::Zero(size, size);
    for (uint32_t b = 0; b < world.bodies.size(); ++b) {
        k.block<3, 3>(6 * b, 6 * b).diagonal().setConstant(masses[b]);
        k.block<3, 3>(6 * b + 3, 6 * b + 3) = hessians[b];
    }
    for (size_t j = 0; j < joints.size(); ++j) {
        const uint32_t count = rowsOf(joints[j].freedom);
        if (count == 0) continue;
        Eigen::MatrixXd own = Eigen::MatrixXd::Zero(count, 6), parent = own;
        own.block<3, 3>(0, 0) = Matrix3d::Identity();
        own.block<3, 3>(0, 3) = -crossMatrix(armNow(joints[j].body, joints[j].side.arm));
        parent.block<3, 3>(0, 0) = -Matrix3d::Identity();
        parent.block<3, 3>(0, 3) = crossMatrix(armNow(joints[j].parent, joints[j].parentSide.arm));
        if (count > 3) {
            // Of a hinge the two axes across its own, x.
            const Matrix3d axes =
                (rotationNow(joints[j].body) * joints[j].side.frame.cast<double>()).toRotationMatrix();
            own.block(3, 3, count - 3, 3) = axes.rightCols(count - 3).transpose();
            parent.block(3, 3, count - 3, 3) = -axes.rightCols(count - 3).transpose();
        }
        k.block(firstRow[j], 6 * joints[j].body, count, 6) = own;
        // Fixed bodies stay, whatever their joints ask for.
        if (!isFixed(joints[j].parent)) k.block(firstRow[j], 6 * joints[j].parent, count, 6) = parent;
    }
    k.topRightCorner(unknowns, size - unknowns) = k.bottomLeftCorner(size - unknowns, unknowns).transpose();
    return k;
}

JointFixture::Solution JointFixture::solution() const
{
    std::vector<uint32_t> firstRow;
    const Eigen::MatrixXd k = system(firstRow);
    const auto joints = trees().all();
    const auto axesOf = [&](const JointTrees::Joint& joint) {
        return (rotationNow(joint.body) * joint.side.frame.cast<double>()).toRotationMatrix();
    };
    Eigen::VectorXd given = Eigen::VectorXd::Zero(k.rows());
    const std::vector<Vector3d> strays = strayTorques();
    for (uint32_t b = 0; b < world.bodies.size(); ++b) given.segment<6>(6 * b) = forces[b];
    for (size_t j = 0; j < joints.size(); ++j) {
        const uint32_t count = rowsOf(joints[j].freedom);
        if (count == 0) continue;
        given.segment<3>(6 * joints[j].body + 3) += strays[j];
        if (!isFixed(joints[j].parent)) given.segment<3>(6 * joints[j].parent + 3) -= strays[j];
        const Vector6d change = left(joints[j]) - error(joints[j], false);
        given.segment<3>(firstRow[j]) = change.head<3>();
        if (count > 3)
            given.segment(firstRow[j] + 3, count - 3) = axesOf(joints[j]).rightCols(count - 3).transpose() *
                                                        change.tail<3>();
    }
    const Eigen::VectorXd x = k.fullPivLu().solve(given);
    Solution found;
    for (uint32_t b = 0; b < world.bodies.size(); ++b) found.motions.emplace_back(x.segment<6>(6 * b));
    for (size_t j = 0; j < joints.size(); ++j) {
        const uint32_t count = rowsOf(joints[j].freedom);
        found.held.push_back(Vector6d::Zero());
        if (count > 0) found.held.back().head<3>() = -x.segment<3>(firstRow[j]);
        if (count > 3)
            found.held.back().tail<3>() = -axesOf(joints[j]).rightCols(count - 3) *
                                          x.segment(firstRow[j] + 3, count - 3);
        found.held.back().tail<3>() += strays[j];
    }
    return found;
}

std::vector<Vector3d> JointFixture::strayTorques() const
{
    const auto joints = trees().all();
    const std::vector<gpu::Joint> infos = stages.joints.jointInfo.download();
    std::vector<Vector3d> strays(joints.size(), Vector3d::Zero());
    for (size_t j = 0; j < joints.size(); ++j) {
        if (joints[j].freedom != JOINT_HINGE) continue;
        const Vector3d axis = rotationNow(joints[j].body) * joints[j].side.frame.cast<double>() * Vector3d::UnitX();
        strays[j] = -axis * axis.dot(vec3(angularRows[infos[j].row]).cast<double>());
    }
    return strays;
}

JointFixture::Matrix6d JointFixture::response(uint32_t body) const
{
    std::vector<uint32_t> firstRow;
    const Eigen::MatrixXd k = system(firstRow);
    Eigen::MatrixXd units = Eigen::MatrixXd::Zero(k.rows(), 6);
    units.block<6, 6>(6 * body, 0).setIdentity();
    return k.fullPivLu().solve(units).block<6, 6>(6 * body, 0);
}

void JointFixture::solve(bool loops, const Defines& more)
{
    const auto groups = (stages.parameters.jointTreeCount + TREE_GROUP_SIZE - 1) / TREE_GROUP_SIZE;
    Defines variant;
    if (!angularRows.empty()) variant.push_back({"ANGULAR", "1"});
    variant.insert(variant.end(), more.begin(), more.end());
    variant.push_back({"RESPONSES", "1"});
    dispatch(load("joint/joint_factor", variant), groups);
    if (loops) dispatch(load("joint/loops/joint_loop_factor", variant), groups);
    dispatch(load("joint/joint_solve", with(loops ? with(variant, "LOOPS") : variant, "FIRST")), groups);
    if (loops) dispatch(load("joint/loops/joint_loop_solve", variant), groups);
    gpu().checkErrors();
}

}  // namespace knuckle::test
