#pragma once

#include <vector>

#include "tests/solver/body/mover_fixture.h"

namespace knuckle::test {

/// Joints in the middle of a substep: bodies that have left their joints by some millimetres and degrees, with random
/// forces on them; and the result of a dense solve in double precision.
class JointFixture : public MoverFixture {
public:
    /// A small motion or a force of a body: a place, then a turn about it.
    using Vector6d = Eigen::Matrix<double, 6, 1>;
    using Matrix6d = Eigen::Matrix<double, 6, 6>;

    explicit JointFixture(World worldIn);

    struct Solution {
        std::vector<Vector6d> motions;  ///< Per body.
        std::vector<Vector6d> held;     ///< Per joint of trees().all(): the force on its body, at the joint.
    };
    /// The least M-weighted motion, M x = f + J^T held, that corrects the substep's part of the joints' errors, J x =
    /// left - error.
    Solution solution() const;
    /// The motions of `body` for a unit force in each direction on it, with closed joints.
    Matrix6d response(uint32_t body) const;
    /// How far a joint's body has left its parent: now, or at the start of the substep.
    Vector6d error(const JointTrees::Joint& joint, bool atStart) const;
    /// The part of an error that is left.
    Vector6d left(const JointTrees::Joint& joint) const;

    /// The kernels of a substep, then of an iteration.
    void solve(bool loops, const Defines& more = {});
    const JointTrees& trees() const { return stages.layout.jointTrees; }
    /// A body's place or arm within it at present.
    Vector3d armNow(uint32_t body, const Vector3f& arm) const;

    std::vector<Vector6d> forces;              ///< Per body.
    std::vector<Matrix3d> hessians;            ///< Per body, symmetric [kg m2].
    std::vector<gpu::vec4> rows, angularRows;  ///< Contents of the channel before.

private:
    void uploadLoads();
    /// Per joint: the correction of the torque that a hinge remembers about its own axis.
    std::vector<Vector3d> strayTorques() const;
    /// K of K [x; -held] = [f; J x]. @param firstRow of each joint.
    Eigen::MatrixXd system(std::vector<uint32_t>& firstRow) const;
    Eigen::Quaterniond rotationNow(uint32_t body) const
    {
        return quaternion(turns[body]).cast<double>() * rotation(body);
    }
};

}  // namespace knuckle::test
