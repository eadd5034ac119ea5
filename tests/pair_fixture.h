#pragma once

#include <vector>

#include "sim/world/builder/builder.h"

namespace knuckle::test {

/// Two cubes of 3x3x3 particles along x, with a joint in their middle.
struct PairSpec {
    JointSpec joint;     ///< At the origin by default.
    float apart = 4.0f;  ///< Between the cubes' centres [diameters]; 4 leaves a free layer.
    uint32_t materialOfA = 0, materialOfB = 0;
    Motion motionOfA = Motion::Dynamic;
    float selfMargin = 0.0f;  ///< Of all particles [diameters].
};

/// Adds the pair as an object of its own: bodies "a" on the side of -x, and "b".
inline void addJointedPair(WorldBuilder& builder, const PairSpec& spec, const Pose& pose = {},
                           const Vector3f& velocity = {0, 0, 0}, const Vector3f& spin = {0, 0, 0})
{
    std::vector<Vector3f> left = boxLattice({3, 3, 3}, builder.diameter()), right = left;
    const Vector3f aside(0.5f * spec.apart * builder.diameter(), 0, 0);
    for (Vector3f& p : left) p -= aside;
    for (Vector3f& p : right) p += aside;
    builder.beginObject("pair");
    const uint32_t a = builder.addBody("a", left, spec.materialOfA, spec.motionOfA);
    const uint32_t b = builder.addBody("b", right, spec.materialOfB);
    builder.addJoint(a, b, spec.joint);
    builder.setSelfMargin(spec.selfMargin);
    builder.endObject(pose, velocity, spin);
}

}  // namespace knuckle::test
