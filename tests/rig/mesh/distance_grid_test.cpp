#include "sim/rig/mesh/distance_grid.h"

#include <gtest/gtest.h>

#include <string>

#include "sim/base/errors.h"
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
    EXPECT_EQ(messageOf(sheet, 0.1f), "the mesh encloses no volume that cells of 0.1 m see; close it, or lower `cell`");
    EXPECT_EQ(messageOf(boxMesh({0, 0, 0}, {5, 5, 5}), 0.01f),
              "cells of 0.01 m need 1.02e+09 of them for a mesh of 10 x 10 x 10 m, the limit is 4000000; raise `cell` "
              "to 0.07 or more");
    EXPECT_EQ(messageOf({}, 0.1f), "the model has no triangles");
}

}  // namespace
}  // namespace knuckle
