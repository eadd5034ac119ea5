#include "sim/solver/layout/joint_edges.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <map>

#include "shared/constants.h"

namespace knuckle {

namespace {

using Eigen::Matrix3f;

Vector3f meanOf(const std::vector<Vector3f>& places)
{
    Vector3f sum = Vector3f::Zero();
    for (const Vector3f& p : places) sum += p;
    return sum / static_cast<float>(places.size());
}

/// The rotation that brings places about their mean nearest to others about theirs.
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

/// @param spread eigenvalues of the shared particles' spread, ascending [m2].
uint32_t freedomOf(const Vector3f& spread, float diameter)
{
    const float least = 1e-4f * diameter * diameter;
    return spread[2] < least ? JOINT_BALL : spread[1] < least ? JOINT_HINGE : JOINT_STIFF;
}

/// Where a body has the joint's x, and its parent the middle of its cone: x of B, or, so that it turns the same way, the
/// opposite of A's.
std::pair<Vector3f, Vector3f> boundedAxes(const JointBounds& bounds, uint32_t body)
{
    if (bounds.bodyB == body) return {bounds.axis, bounds.cone};
    return {-bounds.cone, -bounds.axis};
}

}  // namespace

std::vector<JointEdge> jointEdges(const World& world)
{
    std::vector<std::vector<uint32_t>> linksOf(world.particles.size());
    for (uint32_t l = 0; l < world.links.size(); ++l)
        if (world.particles[world.links[l].particle].bodyCount > 1) linksOf[world.links[l].particle].push_back(l);
    std::map<std::pair<uint32_t, uint32_t>, JointEdge> edges;
    for (const auto& links : linksOf) {
        for (size_t i = 0; i < links.size(); ++i) {
            for (size_t j = i + 1; j < links.size(); ++j) {
                const Link &a = world.links[std::min(links[i], links[j])],
                           &b = world.links[std::max(links[i], links[j])];
                JointEdge& edge = edges[{a.body, b.body}];
                edge.a = a.body;
                edge.b = b.body;
                edge.particles.push_back(a.particle);
                edge.armsA.push_back(a.restOffset);
                edge.armsB.push_back(b.restOffset);
            }
        }
    }
    for (uint32_t k = 0; k < world.jointBounds.size(); ++k) {
        const auto [a, b] = std::minmax(world.jointBounds[k].bodyA, world.jointBounds[k].bodyB);
        if (const auto edge = edges.find({a, b}); edge != edges.end()) edge->second.bounds = k;
    }
    for (const Joint& joint : world.joints) {
        const uint32_t bodies[] = {joint.bodyA, joint.bodyB, joint.middleBody};
        for (const auto& [i, j] : {std::pair{0, 1}, std::pair{0, 2}, std::pair{1, 2}}) {
            const auto edge = edges.find(std::minmax(bodies[i], bodies[j]));
            if (edge == edges.end()) continue;
            JointStrength& strength = edge->second.strength;
            strength.force = std::min(strength.force, joint.strength.force);
            strength.torque = std::min(strength.torque, joint.strength.torque);
        }
    }
    std::vector<JointEdge> all;
    for (auto& [bodies, edge] : edges) all.push_back(std::move(edge));
    return all;
}

JointTrees::Joint jointOf(const World& world, const JointEdge& edge, uint32_t body)
{
    const bool isA = edge.a == body;
    const std::vector<Vector3f>&own = isA ? edge.armsA : edge.armsB, &others = isA ? edge.armsB : edge.armsA;
    JointTrees::Joint joint;
    joint.body = body;
    joint.parent = isA ? edge.b : edge.a;
    joint.arm = meanOf(own);
    joint.parentArm = meanOf(others);
    Matrix3f spread = Matrix3f::Zero();
    for (const Vector3f& p : own) spread += (p - joint.arm) * (p - joint.arm).transpose();
    const Eigen::SelfAdjointEigenSolver<Matrix3f> eigen(spread);
    joint.freedom = freedomOf(eigen.eigenvalues(), world.diameter());
    Vector3f axis = joint.freedom == JOINT_BALL ? Vector3f::UnitX() : Vector3f(eigen.eigenvectors().col(2));
    joint.bounds = edge.bounds;
    joint.strength = edge.strength;
    joint.particles = edge.particles;
    Quaternionf leaning = Quaternionf::Identity();
    if (edge.bounds != NO_INDEX) {
        const auto [ownAxis, middle] = boundedAxes(world.jointBounds[edge.bounds], body);
        if (joint.freedom != JOINT_BALL) axis *= axis.dot(ownAxis) < 0 ? -1.0f : 1.0f;
        else {
            axis = ownAxis;
            leaning = Quaternionf::FromTwoVectors(ownAxis, middle);
        }
    }
    joint.frame = Quaternionf::FromTwoVectors(Vector3f::UnitX(), axis);
    joint.parentFrame = leaning * joint.frame;
    if (joint.freedom == JOINT_HINGE) {
        const Vector3f along = own.back() - own.front(), parentAlong = others.back() - others.front();
        joint.parentFrame = Quaternionf::FromTwoVectors(along, parentAlong) * joint.frame;
    }
    if (joint.freedom == JOINT_STIFF) joint.parentFrame = fitted(own, others) * joint.frame;
    return joint;
}

}  // namespace knuckle
