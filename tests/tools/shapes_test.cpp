#include <gtest/gtest.h>

#include <array>

#include <stdexcept>

#include "tests/tools/model_checks.h"
#include "tools/shapes/figure.h"

namespace knuckle {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

constexpr double RADIUS = 0.05;  // [m]

/// A ball whose cells are finer on one side, of two regions that meet at x = 0.01.
Figure ball()
{
    Figure figure;
    figure.distance = [](const Vector3d& p) { return p.norm() - RADIUS; };
    figure.grid = {{0, 0, 0}, 0.002, 7, [](const Vector3d& p) { return p.y() > 0.01 ? 0.002 : 0.008; }};
    figure.regionAt = [](const Vector3d& p) { return p.x() > 0.01 ? 1u : 0u; };
    figure.colorAt = [](Region region, const Vector3d&) { return region ? Vector3f(1, 0, 0) : Vector3f(0, 0, 1); };
    figure.weightsAt = [](Region, const Vector3d&) { return SkinWeights{{0}, {1}}; };
    return figure;
}

TEST(Shapes, aBallOfSeveralCellSizesIsClosedAndRound)
{
    const Model model = makeModel("ball", {}, std::array{ball()});
    EXPECT_EQ(test::openEdges(model), 0u);
    size_t fine = 0;
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        EXPECT_NEAR(model.vertices[v].norm(), RADIUS, 2e-4);
        EXPECT_GT(model.surface.vertices[v].normal.dot(model.vertices[v].normalized()), 0.99f);
        fine += model.vertices[v].y() > 0.01f ? 1 : 0;
    }
    EXPECT_GT(fine, 3 * (model.vertices.size() - fine));
}

TEST(Shapes, regionsMeetWhereTheyAreSaidTo)
{
    const Model model = makeModel("ball", {}, std::array{ball()});
    for (size_t v = 0; v < model.vertices.size(); ++v) {
        const bool red = model.surface.vertices[v].color.x() > 0.5f;
        // Half a millimetre: cuts keep away from corners.
        if (red) EXPECT_GT(model.vertices[v].x(), 0.0095f);
        else EXPECT_LT(model.vertices[v].x(), 0.0105f);
    }
}

TEST(Shapes, whatLeavesTheGridIsRefused)
{
    Figure figure = ball();
    figure.distance = [](const Vector3d& p) { return p.norm() - 4 * RADIUS; };
    EXPECT_THROW(surfaceNets(figure.distance, figure.grid), std::logic_error);
    figure = ball();
    figure.grid.centre.x() = 0.128;
    EXPECT_THROW(surfaceNets(figure.distance, figure.grid), std::logic_error);
}

}  // namespace
}  // namespace knuckle
