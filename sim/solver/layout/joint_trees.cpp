#include "sim/solver/layout/joint_trees.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "shared/constants.h"
#include "sim/solver/layout/joint_edges.h"
#include "sim/world/disjoint_sets.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

bool isFixed(const World& world, uint32_t body)
{
    return world.bodies[body].motion == Motion::Fixed;
}

/// Kruskal: the edges that connect what nothing before has connected, those with limits first, then those with most
/// particles, and those that lead to fixed bodies, which count as one, last. The others follow them.
/// @returns how many connect.
size_t connect(const World& world, std::vector<JointEdge>& edges)
{
    const auto held = [&](const JointEdge& e) { return isFixed(world, e.a) || isFixed(world, e.b); };
    std::erase_if(edges, [&](const JointEdge& e) { return isFixed(world, e.a) && isFixed(world, e.b); });
    std::ranges::stable_sort(edges, [&](const JointEdge& x, const JointEdge& y) {
        if (held(x) != held(y)) return held(y);
        if ((x.bounds == NO_INDEX) != (y.bounds == NO_INDEX)) return y.bounds == NO_INDEX;
        return x.particles.size() > y.particles.size();
    });
    const auto ground = static_cast<uint32_t>(world.bodies.size());
    DisjointSets sets(ground + 1);
    const auto joins = [&](const JointEdge& e) {
        const uint32_t a = sets.find(isFixed(world, e.a) ? ground : e.a);
        const uint32_t b = sets.find(isFixed(world, e.b) ? ground : e.b);
        if (a != b) sets.unite(a, b);
        return a != b;
    };
    return static_cast<size_t>(std::stable_partition(edges.begin(), edges.end(), joins) - edges.begin());
}

/// Adds the tree of a body that is in none yet, from `edge` or without one, breadth first.
class TreeGrower {
public:
    TreeGrower(const World& world, const std::vector<JointEdge>& edges, size_t count, JointTrees& out)
        : world_(world), edges_(edges), out_(out), edgesOfBody_(world.bodies.size()),
          jointOfBody_(world.bodies.size(), NO_INDEX), treeOfBody_(world.bodies.size(), NO_INDEX)
    {
        for (uint32_t e = 0; e < count; ++e) {
            for (const uint32_t particle : edges[e].particles) cover(particle, edges[e]);
            edgesOfBody_[edges[e].a].push_back(e);
            edgesOfBody_[edges[e].b].push_back(e);
        }
    }

    void growAll()
    {
        for (uint32_t b = 0; b < world_.bodies.size(); ++b)
            if (isFixed(world_, b))
                for (const uint32_t e : edgesOfBody_[b]) grow(jointOf(world_, edges_[e], other(edges_[e], b)));
        for (uint32_t b = 0; b < world_.bodies.size(); ++b) {
            if (isFixed(world_, b) || edgesOfBody_[b].empty() || jointOfBody_[b] != NO_INDEX) continue;
            JointTrees::Joint root;
            root.body = b;
            root.freedom = JOINT_NONE;
            grow(root);
        }
    }

    /// Behind the trees: what edges beyond the first `count` hold in addition, grouped by tree.
    void closeLoops(size_t count)
    {
        std::vector<std::vector<JointTrees::Joint>> loops(out_.trees.size());
        for (size_t e = count; e < edges_.size(); ++e) {
            const JointEdge edge = uncovered(edges_[e]);
            if (edge.particles.empty()) continue;
            const uint32_t body = isFixed(world_, edge.a) ? edge.b : edge.a;
            JointTrees::Joint loop = jointOf(world_, edge, body);
            if (loop.bounds != NO_INDEX)
                throw InputError(
                    fmt::format("the joint of \"{}\" and \"{}\" closes a loop of joints with limits, which "
                                "cannot be; leave one joint of the loop without",
                                world_.bodies[edge.a].name, world_.bodies[edge.b].name));
            loop.bodyJoint = jointOfBody_[body];
            loop.parentJoint = jointOfBody_[loop.parent];
            loops[treeOfBody_[body]].push_back(loop);
        }
        for (size_t t = 0; t < loops.size(); ++t) {
            out_.trees[t].firstLoop = static_cast<uint32_t>(out_.loops.size());
            out_.loops.insert(out_.loops.end(), loops[t].begin(), loops[t].end());
            out_.trees[t].loopEnd = static_cast<uint32_t>(out_.loops.size());
        }
    }

private:
    static uint32_t other(const JointEdge& edge, uint32_t body) { return edge.a == body ? edge.b : edge.a; }

    void grow(const JointTrees::Joint& root)
    {
        JointTrees::Tree tree;
        tree.first = static_cast<uint32_t>(out_.joints.size());
        add(root);
        for (uint32_t k = tree.first; k < out_.joints.size(); ++k) {
            const uint32_t body = out_.joints[k].body, parent = out_.joints[k].parent;
            out_.joints[k].firstChild = static_cast<uint32_t>(out_.joints.size());
            for (const uint32_t e : edgesOfBody_[body]) {
                const uint32_t child = other(edges_[e], body);
                if (child == parent || isFixed(world_, child)) continue;
                JointTrees::Joint joint = jointOf(world_, edges_[e], child);
                joint.parentJoint = k;
                add(joint);
            }
            out_.joints[k].childEnd = static_cast<uint32_t>(out_.joints.size());
        }
        tree.end = static_cast<uint32_t>(out_.joints.size());
        out_.trees.push_back(tree);
    }

    void add(JointTrees::Joint joint)
    {
        joint.bodyJoint = jointOfBody_[joint.body] = static_cast<uint32_t>(out_.joints.size());
        treeOfBody_[joint.body] = static_cast<uint32_t>(out_.trees.size());
        out_.joints.push_back(joint);
    }

    /// Less the particles through which the trees, and loops before it, hold its bodies together already.
    JointEdge uncovered(const JointEdge& edge)
    {
        JointEdge rest = edge;
        rest.particles.clear();
        rest.armsA.clear();
        rest.armsB.clear();
        for (size_t i = 0; i < edge.particles.size(); ++i) {
            if (!cover(edge.particles[i], edge)) continue;
            rest.particles.push_back(edge.particles[i]);
            rest.armsA.push_back(edge.armsA[i]);
            rest.armsB.push_back(edge.armsB[i]);
        }
        return rest;
    }

    /// @returns whether the particle's bodies were not connected through it before.
    bool cover(uint32_t particle, const JointEdge& edge)
    {
        auto& bodies = covered_[particle];
        const auto group = [&](uint32_t body) { return bodies.try_emplace(body, body).first->second; };
        const uint32_t a = group(edge.a), b = group(edge.b);
        for (auto& [body, its] : bodies)
            if (its == b) its = a;
        return a != b;
    }

    const World& world_;
    const std::vector<JointEdge>& edges_;
    JointTrees& out_;
    std::vector<std::vector<uint32_t>> edgesOfBody_;
    std::vector<uint32_t> jointOfBody_, treeOfBody_;
    std::map<uint32_t, std::map<uint32_t, uint32_t>> covered_;  ///< Per particle and body: bodies of a group have one.
};

}  // namespace

std::vector<JointTrees::Joint> JointTrees::all() const
{
    std::vector<Joint> both = joints;
    both.insert(both.end(), loops.begin(), loops.end());
    return both;
}

JointTrees::JointTrees(const World& world)
{
    std::vector<JointEdge> edges = jointEdges(world);
    const size_t count = connect(world, edges);
    TreeGrower grower(world, edges, count, *this);
    grower.growAll();
    grower.closeLoops(count);
    std::ranges::stable_sort(trees, [](const Tree& x, const Tree& y) { return x.end - x.first > y.end - y.first; });
}

}  // namespace knuckle
