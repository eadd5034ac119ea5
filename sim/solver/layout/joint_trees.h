#pragma once

#include <cstdint>
#include <vector>

#include "sim/world/world.h"

namespace knuckle {

/// How joints connect the bodies that move: as trees, which can be solved directly, and what closes loops in them.
/// Fixed bodies do not belong to trees, they hold them. Everything follows from the particles that bodies share: one
/// place holds it together, a line lets it turn about itself, a face not at all. Made from the World alone.
struct JointTrees {
    /// Between a body and its parent.
    struct Joint {
        uint32_t body = 0, parent = NO_INDEX;   ///< Bodies; a root that nothing holds has no parent.
        uint32_t firstChild = 0, childEnd = 0;  ///< `joints` of what hangs on the body.
        uint32_t bodyJoint = NO_INDEX;          ///< Index into `joints` of the body's own ...
        uint32_t parentJoint = NO_INDEX;        ///< ... and of its parent's; NO_INDEX of a fixed parent.
        Vector3f arm{0, 0, 0};                  ///< The middle of the shared particles, in the body's axes [m].
        Vector3f parentArm{0, 0, 0};            ///< The same in the parent's.
        Quaternionf frame{1, 0, 0, 0};          ///< From the joint's axes to the body's; a hinge turns about x.
        Quaternionf parentFrame{1, 0, 0, 0};  ///< The same to the parent's; equal in space where the joint is at rest.
        uint32_t freedom = 0;                 ///< JOINT_*.
        /// Of World::jointBounds: x of `frame` turns in a cone about x of `parentFrame`, and about itself.
        uint32_t bounds = NO_INDEX;
        JointStrength strength;
        std::vector<uint32_t> particles;  ///< That both bodies share.
    };
    /// Joints of a tree: parents stand before children.
    struct Tree {
        uint32_t first = 0, end = 0;          ///< Of `joints`.
        uint32_t firstLoop = 0, loopEnd = 0;  ///< Of `loops`.
    };

    JointTrees() = default;
    /// @throws InputError for a loop of joints that all have limits.
    explicit JointTrees(const World& world);

    /// `joints`, then `loops`.
    std::vector<Joint> all() const;

    std::vector<Joint> joints;  ///< One for each body of a tree.
    std::vector<Joint> loops;   ///< Between bodies that a tree connects already; `body` belongs to the tree.
    std::vector<Tree> trees;    ///< The largest first.
};

}  // namespace knuckle
