#include "sim/rig/limbs/limb_frame.h"
#include "sim/rig/actor.h"

#include <gtest/gtest.h>

#include "tests/directions.h"

namespace knuckle::test {
namespace {

void expectAcross(const Vector3f& across, const Vector3f& along)
{
    ASSERT_NEAR(across.norm(), 1.0f, 1e-5f) << along.transpose();
    ASSERT_NEAR(across.dot(along), 0.0f, 1e-4f) << along.transpose();
}

TEST(LimbFrame, EveryDirectionHasOneAcross)
{
    for (const Vector3f& along : directions()) {
        for (int axis = 0; axis < 3; ++axis) {
            expectAcross(perpendicular(Vector3f::Unit(axis), along), along);
            expectAcross(acrossLimb(along, -Vector3f::Unit(axis)), along);
        }
        expectAcross(perpendicular(along, along), along);
        expectAcross(perpendicular(Vector3f::Zero(), along), along);
        expectAcross(acrossLimb(along, along), along);
    }
}

}  // namespace
}  // namespace knuckle::test
