#pragma once

#include "tests/solver/solver_test.h"

namespace knuckle::test {

/// Rounding of single precision, relative to the rounded number.
inline constexpr double EPSILON = 0x1p-24;

/// A linear field over a mover (shaders/sim/common/bodies/fields.glsl), in double precision: t + f r.
struct Field {
    Vector3d t = Vector3d::Zero();
    Matrix3d f = Matrix3d::Zero();

    Vector3d at(const Vector3d& r) const { return t + f * r; }
    /// Adds an impulse or a velocity p at r.
    void add(const Vector3d& p, const Vector3d& r)
    {
        t += p;
        f += p * r.transpose();
    }
    /// An upper bound of the sum of sizes at r.
    double size(const Vector3d& r) const { return t.norm() + f.norm() * r.norm(); }
};

/// A particle of a mover, from the World.
struct Part {
    uint32_t particle = 0;
    Vector3d r = Vector3d::Zero();  ///< From the mover's centre at rest [m].
    double mass = 0.0;              ///< In this mover [kg].
};

/// A KernelFixture in the middle of a run: every mover at a random place, substep 9, lists of contacts in the second
/// half.
class MoverFixture : public KernelFixture {
public:
    static constexpr uint32_t SUBSTEP = 9;

    explicit MoverFixture(World worldIn = mixedWorld());

    uint32_t moverCount() const { return stages.parameters.moverCount; }
    bool isBody(uint32_t mover) const { return mover < world.bodies.size(); }
    bool isFixed(uint32_t mover) const { return isBody(mover) && world.bodies[mover].motion == Motion::Fixed; }
    double radius(uint32_t mover) const;
    /// Makes all bodies count as free of joints, including those fixed for ever.
    void treatAllAsFree();
    /// Runs a kernel that is compiled for each kind: for bodies without joints, then for loose particles.
    void forFreeAndLoose(const std::string& kernel, const Defines& defines = {});
    /// The shaders' index of a mover's field in an array of fields.
    uint32_t fieldStart(uint32_t mover) const;
    Field field(const std::vector<gpu::vec4>& fields, uint32_t mover) const;
    /// Random fields, t within +-ofT and the entries of f within +-ofF.
    std::vector<gpu::vec4> randomFields(float ofT, float ofF, uint32_t seed) const;
    /// Sums of three impulses on particles of each mover, each of which moves the mover's mass by up to `move` [m].
    std::vector<gpu::vec4> randomImpulses(float move, uint32_t seed) const;
    /// Sets per mover a move within +-`move` [m], w as given, and a turn by up to `angle`, none for loose particles.
    void setMoves(float move, float angle, float w);
    /// Sets for all assemblies the substep of the last contact and the order.
    void setAssemblies(uint32_t lastContact, uint32_t order);

    Vector3d centre(uint32_t mover) const { return vec3(centres[mover]).cast<double>(); }
    Eigen::Quaterniond rotation(uint32_t mover) const { return quaternion(rotations[mover]).cast<double>(); }
    /// From the mover's centre to r, at the start of the substep.
    Vector3d arm(uint32_t mover, const Vector3d& r) const { return rotation(mover) * r; }
    /// The move of the point r of a mover by setMoves.
    Vector3d moveOf(uint32_t mover, const Vector3d& r) const;

    std::vector<std::vector<Part>> parts;  ///< Per mover.
    std::vector<double> masses;            ///< Per mover [kg].
    std::vector<uint32_t> moverOf;         ///< Per particle: its first body, or itself.
    std::vector<gpu::vec4> centres, rotations, moves, turns;

private:
    void findParts();
};

/// The rotation nearest to `a` (the Q of eq. 11): as a quaternion it is the dominant eigenvector of a symmetric 4x4
/// matrix (Horn 1987; Higham and Noferini 2016).
Eigen::Quaterniond nearestRotation(const Matrix3d& a);

/// How far `found` is from a rotation nearest to `a`, as far as `a` determines it: completely, only the direction of a
/// straight body, or not at all. @param moments sum of m r r^T: its rank tells which.
double rotationError(const Eigen::Quaterniond& found, const Matrix3d& a, const Matrix3d& moments);

}  // namespace knuckle::test
