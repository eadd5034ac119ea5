#include "sim/rig/mesh/distance_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "sim/base/errors.h"
#include "sim/rig/mesh/open_edges.h"
#include "tests/rig/shapes.h"

namespace knuckle {
namespace {

ColliderGrid gridOf(const TriangleMesh& mesh, float cell)
{
    return makeDistanceGrid(mesh.vertices, mesh.triangles, cell);
}

std::string messageOf(const TriangleMesh& mesh, float cell)
{
    try {
        gridOf(mesh, cell);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(DistanceGrid, OfASphereHasItsDistancesWithinAShareOfACell)
{
    const ColliderGrid grid = gridOf(sphereMesh(1.0f), 0.1f);
    for (int i = 0; i < 2000; ++i) {
        // Points all over the shell from 0.5 to 1.15, without order.
        const float t = static_cast<float>(i), height = 2.0f * std::fmod(t * 0.618f, 1.0f) - 1.0f;
        const float ring = std::sqrt(1.0f - height * height), radius = 0.5f + 0.65f * std::fmod(t * 0.755f, 1.0f);
        const Eigen::Vector3f point = radius * Eigen::Vector3f(ring * std::cos(t), height, ring * std::sin(t));
        // A trilinear interpolant is off by 3/8 of the cell squared times the curvature, 2 at the radius 0.5; the mesh
        // is within 0.0022 of the sphere.
        EXPECT_NEAR(meshDistance(grid, point), radius - 1.0f, 0.375f * 0.01f * 2.0f + 0.0025f);
    }
}

TEST(DistanceGrid, BeyondItDistancesAreThoseToTheSurface)
{
    const ColliderGrid grid = gridOf(boxMesh({1, 2, 3}, {0.5f, 0.25f, 0.3f}), 0.1f);
    // Over the middle of a face the grid's own values are exact, and what lies beyond goes on from them; over an edge
    // the gradient where the grid ends is off by a trilinear cell's.
    for (float far = 0.01f; far < 5.0f; far += 0.05f) {
        EXPECT_NEAR(meshDistance(grid, {1.5f + far, 2, 3}), far, 1e-4f);
        EXPECT_NEAR(meshDistance(grid, {1, 2.25f + far, 3}), far, 1e-4f);
        EXPECT_NEAR(meshDistance(grid, {1.5f + far, 2.25f + far, 3}), std::sqrt(2.0f) * far, 0.03f);
    }
}

TEST(DistanceGrid, TrianglesMayFaceEitherWay)
{
    TriangleMesh mesh = boxMesh({0, 0, 0}, {0.5f, 0.5f, 0.5f});
    for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(meshDistance(gridOf(mesh, 0.1f), {0.2f, 0, 0}), -0.3f, 1e-3f);
}

TEST(DistanceGrid, RefusesWhatHasNoVolumeAndTooManyCells)
{
    TriangleMesh sheet;
    sheet.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}};
    sheet.triangles = {{0, 1, 2}};
    EXPECT_EQ(messageOf(sheet, 0.1f), "the mesh encloses no volume that cells of 0.1 m see; close it, lower `cell`, or "
                                      "give a sheet a `thickness`");
    EXPECT_EQ(messageOf(boxMesh({0, 0, 0}, {5, 5, 5}), 0.01f),
              "cells of 0.01 m need 1.02e+09 of them for a mesh of 10 x 10 x 10 m, the limit is 4000000; raise `cell` "
              "to 0.07 or more");
    EXPECT_EQ(messageOf({}, 0.1f), "the model has no triangles");
}

/// Without its lid a box is as solid as before, on every row of the grid.
TEST(DistanceGrid, CountsAnOpeningAsCovered)
{
    TriangleMesh mesh = boxMesh({0, 0, 0}, {0.5f, 0.5f, 0.5f});
    EXPECT_EQ(widestOpening(mesh.vertices, mesh.triangles), 0.0f);
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](uint32_t v) { return mesh.vertices[v].y() > 0.0f; });
    });
    ASSERT_EQ(mesh.triangles.size(), 10u);
    EXPECT_NEAR(widestOpening(mesh.vertices, mesh.triangles), std::sqrt(2.0f), 1e-5f);
    const ColliderGrid grid = gridOf(mesh, 0.05f);
    for (const float x : {-0.3f, 0.0f, 0.3f})
        for (const float z : {-0.3f, 0.0f, 0.3f}) {
            EXPECT_LT(meshDistance(grid, {x, 0.2f, z}), 0.0f);
            EXPECT_GT(meshDistance(grid, {x, 0.75f, z}), 0.0f);
        }
}

TEST(DistanceGrid, OfASheetIsSolidHalfItsThicknessToBothSides)
{
    TriangleMesh sheet;
    sheet.vertices = {{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}};
    sheet.triangles = {{0, 2, 1}, {0, 3, 2}};
    const ColliderGrid grid = makeSheetGrid(sheet.vertices, sheet.triangles, 0.025f, 0.06f);
    for (const float y : {-0.1f, -0.05f, 0.05f, 0.1f})
        EXPECT_NEAR(meshDistance(grid, {0.13f, y, 0.21f}), std::abs(y) - 0.03f, 1e-4f) << y;
    EXPECT_NEAR(meshDistance(grid, {1.1f, 0, 0}), 0.07f, 1e-3f);
    EXPECT_LT(meshDistance(grid, {0.13f, 0, 0.21f}), 0.0f);
    // Drawn: two sides of two triangles each, and a rim of two for each of four edges, closed.
    EXPECT_EQ(grid.triangles.size(), 12u);
    EXPECT_EQ(widestOpening(grid.vertices, grid.triangles), 0.0f);
    for (const Eigen::Vector3f& vertex : grid.vertices) EXPECT_NEAR(std::abs(vertex.y()), 0.03f, 1e-6f);
}

}  // namespace
}  // namespace knuckle
