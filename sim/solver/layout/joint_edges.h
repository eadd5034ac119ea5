#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "sim/solver/layout/joint_trees.h"

namespace knuckle {

/// Two bodies that share particles, and where these stand in each.
struct JointEdge {
    uint32_t a = 0, b = 0;
    uint32_t bounds = NO_INDEX;  ///< Of World::jointBounds.
    JointStrength strength;      ///< The least of the joints between the two.
    std::vector<uint32_t> particles;
    std::vector<Vector3f> armsA, armsB;  ///< Per particle, in the axes of the body [m].
};

/// All pairs of bodies that share particles, by their indices.
std::vector<JointEdge> jointEdges(const World& world);

/// The joint that an edge is for one of its bodies. What it lets turn follows from how its particles lie: one place
/// holds it together, a line lets it turn about itself, a face not at all.
JointTrees::Joint jointOf(const World& world, const JointEdge& edge, uint32_t body);

}  // namespace knuckle
