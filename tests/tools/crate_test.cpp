#include <gtest/gtest.h>

#include "sim/rig/mesh/voxelize.h"
#include "tests/tools/model_checks.h"
#include "tools/crate/crate.h"

namespace knuckle {
namespace {

TEST(Crate, isClosedAndAsLargeAsNineParticles)
{
    const Model model = makeCrate();
    EXPECT_EQ(test::openEdges(model), 0u);
    const Solid solid(model.vertices, model.triangles);
    EXPECT_LT((solid.bounds().max() - Eigen::Vector3f::Constant(0.135f)).norm(), 1e-5f);
    EXPECT_LT((solid.bounds().min() + Eigen::Vector3f::Constant(0.135f)).norm(), 1e-5f);
    // No gap between planks is deep enough for a particle to be missing: its sides are flat.
    EXPECT_EQ(voxelize(solid, {.diameter = 0.03f}).positions.size(), 9u * 9 * 9);
}

TEST(Crate, isCommittedAsTheCodeMakesIt)
{
    test::expectCommitted("crate", makeCrate());
}

}  // namespace
}  // namespace knuckle
