#include "sim/solver/layout/drive_inertia.h"

#include <Eigen/LU>
#include <algorithm>

#include "sim/world/no_index.h"

namespace knuckle {

namespace {

/// Bodies made one.
struct Composite {
    double mass = 0.0;
    Eigen::Vector3d centre = Eigen::Vector3d::Zero();    ///< In the rest pose [m].
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();   ///< About the centre [kg m2].
};

Eigen::Matrix3d crossMatrix(const Eigen::Vector3d& v)
{
    Eigen::Matrix3d m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

Eigen::Vector3d restPlace(const World& world, const Link& link)
{
    return (world.bodies[link.body].restCentre + link.restOffset).cast<double>();
}

Composite composite(const World& world, const Object& object, const std::vector<bool>& chosen)
{
    Composite all;
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
    const auto forEach = [&](auto visit) {
        for (uint32_t b = 0; b < object.bodyCount; ++b) {
            const Body& body = world.bodies[object.bodyStart + b];
            for (uint32_t k = 0; chosen[b] && k < body.linkCount; ++k) visit(world.links[body.linkStart + k]);
        }
    };
    forEach([&](const Link& link) {
        all.mass += double{link.mass};
        all.centre += double{link.mass} * restPlace(world, link);
    });
    all.centre /= all.mass;
    forEach([&](const Link& link) {
        const Eigen::Vector3d r = restPlace(world, link) - all.centre;
        moments += double{link.mass} * r * r.transpose();
    });
    // A row of particles has none about itself, and nothing could be solved with it.
    const double least = 1e-5 * all.mass * double{world.diameter()} * double{world.diameter()};
    all.inertia = (moments.trace() + least) * Eigen::Matrix3d::Identity() - moments;
    return all;
}

/// Per body of an object whether it hangs on one of them.
std::vector<bool> hangingOn(const std::vector<AnimatedLink>& links, uint32_t top)
{
    std::vector<bool> hangs(links.size(), false);
    for (uint32_t b = 0; b < links.size(); ++b) {
        uint32_t above = b;
        while (above != NO_INDEX && above != top) above = links[above].parent;
        hangs[b] = above == top;
    }
    return hangs;
}

/// Whether something fixed for ever holds one of the chosen bodies, or a clip still moves one when another is let go.
bool isHeld(const World& world, const Object& object, const std::vector<bool>& chosen, float release)
{
    for (uint32_t b = 0; b < object.bodyCount; ++b)
        if (chosen[b] && world.bodies[object.bodyStart + b].releaseTime > release) return true;
    const auto chosenBody = [&](uint32_t body) {
        return body >= object.bodyStart && body < object.bodyStart + object.bodyCount && chosen[body - object.bodyStart];
    };
    return std::ranges::any_of(world.joints, [&](const Joint& joint) {
        return (chosenBody(joint.parent) && neverResponds(world.bodies[joint.child])) ||
               (chosenBody(joint.child) && neverResponds(world.bodies[joint.parent]));
    });
}

/// How a side of a joint answers to forces there.
struct Side {
    double inverseMass = 0.0;
    Eigen::Matrix3d inverseInertia = Eigen::Matrix3d::Zero();
    Eigen::Matrix3d arm = Eigen::Matrix3d::Zero();  ///< The matrix of the cross product with it.
};

Side sideOf(const Composite& all, const Eigen::Vector3d& anchor)
{
    return {1.0 / all.mass, all.inertia.inverse(), crossMatrix(anchor - all.centre)};
}

}  // namespace

Eigen::Matrix3d turnedInertia(const World& world, const Object& object, const std::vector<AnimatedLink>& links,
                              uint32_t body)
{
    const Eigen::Vector3d anchor = links[body].anchor.cast<double>();
    std::vector<bool> chosen = hangingOn(links, body);
    const Side child = sideOf(composite(world, object, chosen), anchor);
    chosen.flip();
    Side parent;
    const float release = world.bodies[object.bodyStart + body].releaseTime;
    if (!isHeld(world, object, chosen, release)) parent = sideOf(composite(world, object, chosen), anchor);
    // A torque between both sides, and the force F that keeps them together at the joint: A F = B torque.
    const Eigen::Matrix3d a = (child.inverseMass + parent.inverseMass) * Eigen::Matrix3d::Identity() -
                              child.arm * child.inverseInertia * child.arm -
                              parent.arm * parent.inverseInertia * parent.arm;
    const Eigen::Matrix3d b = child.arm * child.inverseInertia + parent.arm * parent.inverseInertia;
    const Eigen::Matrix3d answer = child.inverseInertia + parent.inverseInertia + b.transpose() * a.inverse() * -b;
    return answer.inverse();
}

std::vector<PinnedMass> pinnedMasses(const World& world, const Object& object, const std::vector<AnimatedLink>& links,
                                     const std::vector<uint32_t>& pinned)
{
    std::vector<PinnedMass> masses;
    for (const uint32_t pin : pinned) {
        std::vector<bool> carried = hangingOn(links, pin);
        for (const uint32_t other : pinned) {
            if (other == pin || !carried[other]) continue;
            const std::vector<bool> others = hangingOn(links, other);
            for (size_t b = 0; b < links.size(); ++b) carried[b] = carried[b] && !others[b];
        }
        const Composite all = composite(world, object, carried);
        const Eigen::Vector3d r = all.centre - world.bodies[object.bodyStart + pin].restCentre.cast<double>();
        const Eigen::Matrix3d x = crossMatrix(r);
        masses.push_back({all.mass, all.inertia - all.mass * x * x});
    }
    return masses;
}

}  // namespace knuckle
