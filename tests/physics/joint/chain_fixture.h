#pragma once

#include "sim/world/builder/builder.h"

namespace knuckle::test {

/// From the middle of a cube of 3 x 3 x 3 to that of the next, with a layer between them for the joint [m].
inline constexpr float PITCH = 0.4f;

struct ChainSpec {
    uint32_t bodies = 10;
    JointType type = JointType::Ball;
    float load = 1.0f;  ///< Mass of the last one, over the others'.
    Vector3f along{0, -1, 0};
    JointStrength strength = {};
    JointLimits limits = {};
    std::vector<uint32_t> alsoHeavy = {};  ///< Further bodies as heavy as the last.
    bool bothEnds = false;                 ///< Whether the last body is fixed, too; the first always is.
};

/// Adds a row of such cubes from the origin, as one object.
void addChain(WorldBuilder& builder, const ChainSpec& spec);
/// A world with only a chain.
World chain(const ChainSpec& spec);

}  // namespace knuckle::test
