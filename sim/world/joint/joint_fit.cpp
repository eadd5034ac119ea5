#include "sim/world/joint/joint_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>

#include "sim/world/space/frames.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;

/// Places of particles in a body [m].
std::vector<Vector3f> armsIn(const World& world, uint32_t body, const std::vector<uint32_t>& particles)
{
    const auto first = world.links.begin() + world.bodies[body].linkStart;
    std::vector<Vector3f> arms;
    for (const uint32_t particle : particles)
        arms.push_back(std::find_if(first, first + world.bodies[body].linkCount, [&](const Link& l) {
                           return l.particle == particle;
                       })->restOffset);
    return arms;
}

Vector3f meanOf(const std::vector<Vector3f>& places)
{
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& p : places) sum += p;
    return sum / static_cast<float>(places.size());
}

/// The rotation that best fits places about their mean to others about theirs.
Quaternionf fitted(const std::vector<Vector3f>& from, const std::vector<Vector3f>& to)
{
    const Vector3f meanFrom = meanOf(from), meanTo = meanOf(to);
    Matrix3f sum = Matrix3f::Zero();
    for (size_t i = 0; i < from.size(); ++i) sum += (to[i] - meanTo) * (from[i] - meanFrom).transpose();
    const Eigen::JacobiSVD<Matrix3f> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
    Matrix3f turned = svd.matrixU();
    if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0.0f) turned.col(2) *= -1.0f;
    return Quaternionf(turned * svd.matrixV().transpose());
}

/// @param spread eigenvalues of the particles' spread, ascending [m2].
JointType typeOf(const Vector3f& spread, float diameter)
{
    const float least = 1e-4f * diameter * diameter;
    return spread[2] < least ? JointType::Ball : spread[1] < least ? JointType::Hinge : JointType::Stiff;
}

}  // namespace

JointFit fitJoint(const World& world, uint32_t body, uint32_t parent, const std::vector<uint32_t>& particles,
                  const Vector3f& axis, const Vector3f& cone, const Quaternionf& turn)
{
    const std::vector<Vector3f> own = armsIn(world, body, particles), others = armsIn(world, parent, particles);
    JointFit fit;
    fit.body.arm = meanOf(own);
    fit.parent.arm = meanOf(others);
    Matrix3f spread = Matrix3f::Zero();
    for (const Vector3f& p : own) spread += (p - fit.body.arm) * (p - fit.body.arm).transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3f> eigen(spread);
    fit.type = typeOf(eigen.eigenvalues(), world.diameter());
    const bool ball = fit.type == JointType::Ball, limited = !axis.isZero();
    Vector3f x = ball ? Vector3f::UnitX() : Vector3f(eigen.eigenvectors().col(2));
    Quaternionf leaning = Quaternionf::Identity();
    if (limited && !ball) x *= x.dot(axis) < 0 ? -1.0f : 1.0f;
    if (limited && ball) {
        x = axis;
        leaning = turnBetween(axis, cone);
    }
    fit.body.frame = turnBetween(Vector3f::UnitX(), x);
    fit.parent.frame = turn * leaning * fit.body.frame;
    if (fit.type == JointType::Hinge) {
        const Vector3f along = turn * (own.back() - own.front()), parentAlong = others.back() - others.front();
        fit.parent.frame = turnBetween(along, parentAlong) * turn * fit.body.frame;
    }
    if (fit.type == JointType::Stiff) fit.parent.frame = fitted(own, others) * fit.body.frame;
    return fit;
}

JointFit fitJoint(const World& world, const Joint& joint, uint32_t body, const std::vector<uint32_t>& particles)
{
    const bool isChild = body == joint.child;
    if (isChild && particles == joint.particles) return {joint.type, joint.childSide, joint.parentSide};
    Vector3f axis = Vector3f::Zero(), cone = axis;
    if (joint.countsAngles()) {
        axis = joint.childSide.frame * Vector3f::UnitX();
        cone = joint.turn.conjugate() * (joint.parentSide.frame * Vector3f::UnitX());
    }
    // Seen from the parent, x of both sides is reversed, so that angles are the same.
    if (isChild) return fitJoint(world, body, joint.parent, particles, axis, cone, joint.turn);
    return fitJoint(world, body, joint.child, particles, joint.turn * -cone, joint.turn * -axis,
                    joint.turn.conjugate());
}

}  // namespace knuckle
