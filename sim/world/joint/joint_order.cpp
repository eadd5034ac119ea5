#include "sim/world/joint/joint_order.h"

#include <algorithm>
#include <numeric>
#include <tuple>

#include "sim/base/disjoint_sets.h"

namespace knuckle {

namespace {

/// Kruskal's order: first joints without a body that never responds, then those with limits or drives,
/// then those with most particles.
std::vector<uint32_t> sortedJoints(const World& world)
{
    const auto isGround = [&](uint32_t body) { return neverResponds(world.bodies[body]); };
    std::vector<uint32_t> order(world.joints.size());
    std::iota(order.begin(), order.end(), 0u);
    std::erase_if(order,
                  [&](uint32_t j) { return isGround(world.joints[j].parent) && isGround(world.joints[j].child); });
    const auto key = [&](uint32_t j) {
        const Joint& joint = world.joints[j];
        return std::tuple(isGround(joint.parent) || isGround(joint.child), !joint.countsAngles(),
                          -static_cast<int64_t>(joint.particles.size()), std::minmax({joint.parent, joint.child}));
    };
    std::ranges::stable_sort(order, {}, key);
    return order;
}

}  // namespace

bool SharedParticles::connect(uint32_t particle, uint32_t a, uint32_t b)
{
    auto& bodies = groups_[particle];
    const auto group = [&](uint32_t body) { return bodies.try_emplace(body, body).first->second; };
    const uint32_t first = group(a), second = group(b);
    for (auto& [body, its] : bodies)
        if (its == second) its = first;
    return first != second;
}

JointOrder orderJoints(const World& world)
{
    const auto ground = static_cast<uint32_t>(world.bodies.size());
    DisjointSets sets(ground + 1);
    const auto setOf = [&](uint32_t body) { return sets.find(neverResponds(world.bodies[body]) ? ground : body); };
    JointOrder order;
    std::vector<uint32_t> others;
    for (const uint32_t j : sortedJoints(world)) {
        const uint32_t a = setOf(world.joints[j].parent), b = setOf(world.joints[j].child);
        (a != b ? order.connecting : others).push_back(j);
        if (a != b) sets.unite(a, b);
    }
    SharedParticles covered;
    const auto uncovered = [&](uint32_t j) {
        std::vector<uint32_t> particles;
        for (const uint32_t particle : world.joints[j].particles)
            if (covered.connect(particle, world.joints[j].parent, world.joints[j].child)) particles.push_back(particle);
        return particles;
    };
    for (const uint32_t j : order.connecting) uncovered(j);
    for (const uint32_t j : others)
        if (LoopJoint loop{j, uncovered(j)}; !loop.particles.empty()) order.loops.push_back(std::move(loop));
    return order;
}

}  // namespace knuckle
