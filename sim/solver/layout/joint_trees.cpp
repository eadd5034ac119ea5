#include "sim/solver/layout/joint_trees.h"

#include <algorithm>

#include "shared/constants.h"
#include "sim/world/joint/joint_fit.h"
#include "sim/world/joint/joint_order.h"

namespace knuckle {

namespace {

uint32_t freedomOf(JointType type)
{
    return type == JointType::Ball ? JOINT_BALL : type == JointType::Hinge ? JOINT_HINGE : JOINT_STIFF;
}

/// A joint of the world, or those of its particles that close a loop, seen from one of its bodies.
JointTrees::Joint jointOf(const World& world, uint32_t index, const std::vector<uint32_t>& particles, uint32_t body)
{
    const Joint& record = world.joints[index];
    const JointFit fit = fitJoint(world, record, body, particles);
    JointTrees::Joint joint;
    joint.joint = index;
    joint.body = body;
    joint.parent = body == record.child ? record.parent : record.child;
    joint.freedom = freedomOf(fit.type);
    joint.side = fit.body;
    joint.parentSide = fit.parent;
    joint.particles = particles;
    return joint;
}

/// Adds the tree of a body that is in none yet, starting from a joint or without one, breadth first.
class TreeGrower {
public:
    TreeGrower(const World& world, const std::vector<uint32_t>& connecting, JointTrees& out)
        : world_(world), out_(out), jointsOfBody_(world.bodies.size()), treeJointOfBody_(world.bodies.size(), NO_INDEX),
          treeOfBody_(world.bodies.size(), NO_INDEX)
    {
        for (const uint32_t j : connecting) {
            jointsOfBody_[world.joints[j].parent].push_back(j);
            jointsOfBody_[world.joints[j].child].push_back(j);
        }
    }

    void growAll()
    {
        for (uint32_t b = 0; b < world_.bodies.size(); ++b)
            if (neverResponds(world_.bodies[b]))
                for (const uint32_t j : jointsOfBody_[b]) grow(treeJoint(j, other(j, b)));
        for (const Motion motion : {Motion::Fixed, Motion::Animated, Motion::Dynamic})
            for (uint32_t b = 0; b < world_.bodies.size(); ++b)
                if (world_.bodies[b].motion == motion) growFrom(b);
    }

    /// Adds, after the trees, the loops: joints that hold in addition, grouped by tree.
    void closeLoops(const std::vector<LoopJoint>& closing)
    {
        std::vector<std::vector<JointTrees::Joint>> loops(out_.trees.size());
        for (const LoopJoint& closed : closing) {
            const auto [a, b] = std::minmax({world_.joints[closed.joint].parent, world_.joints[closed.joint].child});
            const uint32_t body = neverResponds(world_.bodies[a]) ? b : a;
            JointTrees::Joint loop = jointOf(world_, closed.joint, closed.particles, body);
            loop.bodyJoint = treeJointOfBody_[body];
            loop.parentJoint = treeJointOfBody_[loop.parent];
            loops[treeOfBody_[body]].push_back(std::move(loop));
        }
        for (const JointTrees::Joint& joint : out_.joints)
            if (isHeldLonger(joint)) loops[treeOfBody_[joint.body]].push_back(standIn(joint));
        for (size_t t = 0; t < loops.size(); ++t) {
            out_.trees[t].firstLoop = static_cast<uint32_t>(out_.loops.size());
            out_.loops.insert(out_.loops.end(), loops[t].begin(), loops[t].end());
            out_.trees[t].loopEnd = static_cast<uint32_t>(out_.loops.size());
        }
    }

private:
    uint32_t other(uint32_t joint, uint32_t body) const
    {
        const Joint& record = world_.joints[joint];
        return record.parent == body ? record.child : record.parent;
    }

    JointTrees::Joint treeJoint(uint32_t joint, uint32_t body) const
    {
        return jointOf(world_, joint, world_.joints[joint].particles, body);
    }

    /// Whether a body may be held while its parent responds: then it holds both what hangs on it and its parent.
    bool isHeldLonger(const JointTrees::Joint& joint) const
    {
        if (joint.parentJoint == NO_INDEX) return false;
        const Body &body = world_.bodies[joint.body], &parent = world_.bodies[joint.parent];
        if (body.motion == Motion::Dynamic) return false;
        if (parent.motion == Motion::Dynamic || parent.releaseTime < body.releaseTime) return true;
        return std::ranges::any_of(world_.releases, [&](const Release& release) {
            const auto has = [&](uint32_t b) { return std::ranges::find(release.bodies, b) != release.bodies.end(); };
            return parent.object == world_.bodies[release.bodies[0]].object && has(joint.parent) && !has(joint.body);
        });
    }

    /// The joint seen from its parent.
    JointTrees::Joint standIn(const JointTrees::Joint& joint) const
    {
        JointTrees::Joint loop = jointOf(world_, joint.joint, joint.particles, joint.parent);
        loop.bodyJoint = joint.parentJoint;
        loop.parentJoint = joint.bodyJoint;
        return loop;
    }

    /// Grows the tree of a body that nothing holds for ever; a body that is held at first becomes its root.
    void growFrom(uint32_t body)
    {
        if (neverResponds(world_.bodies[body]) || jointsOfBody_[body].empty() || treeJointOfBody_[body] != NO_INDEX)
            return;
        JointTrees::Joint root;
        root.body = body;
        root.freedom = JOINT_NONE;
        grow(root);
    }

    void grow(const JointTrees::Joint& root)
    {
        JointTrees::Tree tree;
        tree.first = static_cast<uint32_t>(out_.joints.size());
        add(root);
        for (uint32_t k = tree.first; k < out_.joints.size(); ++k) {
            const uint32_t body = out_.joints[k].body, parent = out_.joints[k].parent;
            out_.joints[k].firstChild = static_cast<uint32_t>(out_.joints.size());
            for (const uint32_t j : jointsOfBody_[body]) {
                const uint32_t child = other(j, body);
                if (child == parent || neverResponds(world_.bodies[child])) continue;
                JointTrees::Joint joint = treeJoint(j, child);
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
        joint.bodyJoint = treeJointOfBody_[joint.body] = static_cast<uint32_t>(out_.joints.size());
        treeOfBody_[joint.body] = static_cast<uint32_t>(out_.trees.size());
        out_.joints.push_back(std::move(joint));
    }

    const World& world_;
    JointTrees& out_;
    std::vector<std::vector<uint32_t>> jointsOfBody_;  ///< Per body, the joints of World::joints that connect it.
    std::vector<uint32_t> treeJointOfBody_, treeOfBody_;
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
    const JointOrder order = orderJoints(world);
    TreeGrower grower(world, order.connecting, *this);
    grower.growAll();
    grower.closeLoops(order.loops);
    std::ranges::stable_sort(trees, [](const Tree& x, const Tree& y) { return x.end - x.first > y.end - y.first; });
}

}  // namespace knuckle
