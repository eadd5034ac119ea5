#include "sim/rig/mesh/polyhedron.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/rig/shapes.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

constexpr float DIAMETER = 0.1f;

/// A box of 0.4 x 0.3 x 0.3 m whose sides lean towards each other, wider on top.
TriangleMesh wedgeMesh()
{
    TriangleMesh mesh = boxMesh({0, 0, 0}, {0.2f, 0.15f, 0.15f});
    for (Vector3f& v : mesh.vertices) v.x() *= 1.0f + v.y();
    return mesh;
}

std::vector<Facet> facetsOf(const TriangleMesh& mesh)
{
    return facetsOf(Solid(mesh.vertices, mesh.triangles));
}

TEST(Polyhedron, OnlyClosedConvexOnesOfFewFacetsHaveAny)
{
    EXPECT_EQ(facetsOf(wedgeMesh()).size(), 6u);
    EXPECT_FALSE(isBoxAlongAxes(facetsOf(wedgeMesh())));
    EXPECT_TRUE(isBoxAlongAxes(facetsOf(boxMesh({1, 2, 3}, {0.2f, 0.3f, 0.4f}))));
    EXPECT_TRUE(facetsOf(boxMesh({0, 0, 0}, {0.2f, 0.2f, 0.2f}, true)).empty()) << "open";
    EXPECT_TRUE(facetsOf(sphereMesh(0.5f)).empty()) << "round";
    TriangleMesh two = boxMesh({0, 0, 0}, {0.2f, 0.2f, 0.2f});
    const TriangleMesh other = boxMesh({1, 0.1f, 0}, {0.2f, 0.2f, 0.2f});
    for (const Triangle& t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
    EXPECT_TRUE(facetsOf(two).empty()) << "not convex";
}

TEST(Polyhedron, OutermostParticlesAreHalfADiameterBehindItsFacets)
{
    const std::vector<Facet> facets = facetsOf(wedgeMesh());
    const std::vector<Vector3f> places = fillPolyhedron(facets, DIAMETER);
    for (const Facet& facet : facets) {
        float deepest = INFINITY;
        for (const Vector3f& place : places) deepest = std::min(deepest, facet.distance - facet.normal.dot(place));
        EXPECT_NEAR(deepest, 0.5f * DIAMETER, 1e-5f);
    }
    // 36 cells have its volume; none is nearer to another than the room that it leaves, 0.6 diameters.
    EXPECT_NEAR(static_cast<double>(places.size()), 36.0, 4.0);
    for (size_t i = 0; i < places.size(); ++i)
        for (size_t k = 0; k < i; ++k) EXPECT_GT((places[i] - places[k]).norm(), 0.59f * DIAMETER);
    EXPECT_TRUE(fillPolyhedron(facets, 0.35f).empty()) << "too thin";
}

TEST(Polyhedron, ParticlesOfTwoThatShareAFacetFaceEachOther)
{
    const TriangleMesh mesh = wedgeMesh();
    const std::vector<Facet> facets = facetsOf(mesh);
    const std::vector<Vector3f> places = fillPolyhedron(facets, DIAMETER);
    const auto side = std::ranges::max_element(facets, {}, [](const Facet& f) { return f.normal.x(); });
    TriangleMesh mirrored = mesh;
    for (Vector3f& v : mirrored.vertices) v -= 2.0f * (side->normal.dot(v) - side->distance) * side->normal;
    const std::vector<Vector3f> others = fillPolyhedron(facetsOf(mirrored), DIAMETER);
    int facing = 0;
    for (const Vector3f& place : places) {
        if (side->distance - side->normal.dot(place) > 0.51f * DIAMETER) continue;
        ++facing;
        const auto isOpposite = [&](const Vector3f& other) {
            return (place + DIAMETER * side->normal - other).norm() < 1e-4f * DIAMETER;
        };
        EXPECT_EQ(std::ranges::count_if(others, isOpposite), 1);
    }
    EXPECT_GE(facing, 9);
}

}  // namespace
}  // namespace knuckle
