#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How joints connect the bodies that may respond: as trees, which can be solved directly, and as loops in them. Bodies
/// that never respond do not belong to trees, they hold them. Made from the World alone.
struct JointTrees {
    /// Between a body and its parent in the tree, which may be the joint's child.
    struct Joint {
        uint32_t joint = NO_INDEX;              ///< Index into World::joints; none for a root that nothing holds.
        uint32_t body = 0, parent = NO_INDEX;   ///< Bodies; such a root has no parent.
        uint32_t firstChild = 0, childEnd = 0;  ///< `joints` of what hangs on the body.
        uint32_t bodyJoint = NO_INDEX;          ///< Index into `joints` of the body's own ...
        uint32_t parentJoint = NO_INDEX;        ///< ... and of its parent's; none if the parent never responds.
        uint32_t freedom = 0;                   ///< JOINT_*.
        JointSide side, parentSide;             ///< Seen from the body.
        std::vector<uint32_t> particles;        ///< Particles through which it holds the two.
    };
    /// Joints of a tree: parents stand before children.
    struct Tree {
        uint32_t first = 0, end = 0;          ///< Of `joints`.
        uint32_t firstLoop = 0, loopEnd = 0;  ///< Of `loops`.
    };

    JointTrees() = default;
    explicit JointTrees(const World& world);

    /// `joints`, then `loops`.
    std::vector<Joint> all() const;

    std::vector<Joint> joints;  ///< One for each body of a tree.
    /// Between bodies that a tree connects already; `body` belongs to the tree. If a body may be held while its parent
    /// in the tree responds, a loop stands in for their joint during that time.
    std::vector<Joint> loops;
    std::vector<Tree> trees;  ///< The largest first.
};

}  // namespace knuckle
