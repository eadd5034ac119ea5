#include "sim/rig/mesh/voxelize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "sim/base/errors.h"
#include "tests/rig/shapes.h"

namespace knuckle {
namespace {

using Eigen::Vector3f;

Voxels fillMesh(const TriangleMesh& mesh, float diameter)
{
    return voxelize(Solid(mesh.vertices, mesh.triangles), {.diameter = diameter});
}

double exactWinding(const TriangleMesh& mesh, const Vector3f& point)
{
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) {
        sum += solidAngle({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]}, point);
    }
    return sum;
}

TEST(TriangleTree, windingNumberOfAFarClusterIsCloseToTheExactSum)
{
    const TriangleMesh mesh = sphereMesh(1.0f);
    const TriangleTree tree(mesh.vertices, mesh.triangles);
    for (int i = 0; i < 60; ++i) {
        const float t = static_cast<float>(i);
        const Vector3f point(1.7f * std::sin(1.3f * t), 1.7f * std::sin(2.1f * t + 1.0f), 1.7f * std::sin(0.7f * t));
        // The dipole omits the second moment: about (1/2)^2 of a cluster's own part, which is below 0.06 here, and the
        // errors of clusters around the point mostly cancel.
        EXPECT_NEAR(tree.windingNumber(point), exactWinding(mesh, point), 0.02) << point.transpose();
    }
}

TEST(TriangleTree, windingNumberIsOneInsideAndZeroOutside)
{
    const TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
    const TriangleTree tree(mesh.vertices, mesh.triangles);
    EXPECT_NEAR(tree.windingNumber({0.3f, -0.5f, 0.8f}), 1.0, 1e-6);
    EXPECT_NEAR(tree.windingNumber({1.2f, 0.1f, 0.1f}), 0.0, 1e-6);
}

TEST(TriangleTree, nearestPointOfABoxIsTheClampedPoint)
{
    const TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 2, 3});
    const TriangleTree tree(mesh.vertices, mesh.triangles);
    const SurfacePoint corner = tree.nearest({4, 6, 7});
    EXPECT_LT((corner.position - Vector3f(1, 2, 3)).norm(), 1e-6f);
    EXPECT_NEAR(corner.distance, std::sqrt(9.0f + 16.0f + 16.0f), 1e-5f);
    const SurfacePoint side = tree.nearest({0.9f, 0.5f, -1.0f});
    EXPECT_LT((side.position - Vector3f(1.0f, 0.5f, -1.0f)).norm(), 1e-6f);
    EXPECT_NEAR(side.barycentric.sum(), 1.0f, 1e-6f);
}

TEST(Voxelize, sphereHoldsTheLatticePointsWithinIt)
{
    const float radius = 1.03f, diameter = 0.1f;
    const Voxels voxels = fillMesh(sphereMesh(radius, 48), diameter);
    // The facets lie between the sphere and one smaller by their sagitta, see the next test.
    int least = 0, most = 0;
    for (int x = -11; x <= 11; ++x) {
        for (int y = -11; y <= 11; ++y) {
            for (int z = -11; z <= 11; ++z) {
                const double r = diameter * std::sqrt(x * x + y * y + z * z);
                least += r < radius - 0.0025;
                most += r < radius;
            }
        }
    }
    EXPECT_GE(static_cast<int>(voxels.positions.size()), least);
    EXPECT_LE(static_cast<int>(voxels.positions.size()), most);
    // 4577 particles by volume; the lattice may deviate by a shell's worth.
    EXPECT_NEAR(most, 4.0 / 3.0 * std::numbers::pi * std::pow(radius / diameter, 3.0), 60.0);
}

TEST(Voxelize, signedDistancesOfASphereAreThoseOfTheFormula)
{
    const Voxels voxels = fillMesh(sphereMesh(1.0f, 48), 0.1f);
    for (size_t p = 0; p < voxels.positions.size(); ++p) {
        // Twice the sagitta of a facet of angle pi / 48 both ways: 1 - cos(pi / 96), about 0.0011, a little more for
        // facets that are not square.
        EXPECT_NEAR(voxels.signedDistances[p], voxels.positions[p].norm() - 1.0f, 0.0025f);
    }
}

TEST(Voxelize, boxIsFilledCellByCell)
{
    // 0.95 x 0.75 x 0.55 around a lattice point: 9 x 7 x 5 points at 0.1 lie inside.
    const Voxels voxels = fillMesh(boxMesh({3, 1, -2}, {0.475f, 0.375f, 0.275f}), 0.1f);
    EXPECT_EQ(voxels.positions.size(), 9u * 7u * 5u);
}

TEST(Voxelize, meshWithOneSideMissingIsStillSolid)
{
    const TriangleMesh open = boxMesh({0, 0, 0}, {0.475f, 0.475f, 0.475f}, true);
    const Voxels voxels = fillMesh(open, 0.1f);
    // Below the middle the winding number stays above one half; by symmetry it is 5/6 at the centre.
    size_t lower = 0;
    for (const Vector3f& p : voxels.positions) {
        lower += p.y() < 0.05f;
    }
    EXPECT_EQ(lower, 9u * 9u * 5u);
    EXPECT_LE(voxels.positions.size(), 9u * 9u * 10u);
}

TEST(Voxelize, meshTurnedInsideOutIsFilledTheSame)
{
    TriangleMesh mesh = sphereMesh(0.5f);
    const size_t count = fillMesh(mesh, 0.1f).positions.size();
    for (Triangle& t : mesh.triangles) {
        std::swap(t[1], t[2]);
    }
    EXPECT_EQ(fillMesh(mesh, 0.1f).positions.size(), count);
}

TEST(Voxelize, thinPlateKeepsExactlyOneLayerWithoutHoles)
{
    // Around a lattice point, and between two: an ear beside the plate moves the lattice by half a cell.
    for (const float shift : {0.0f, 0.5f}) {
        const float d = 0.1f;
        TriangleMesh mesh = boxMesh({0, 0, 0}, {0.975f, 0.002f, 0.975f});
        const TriangleMesh ear = boxMesh({0, shift * d, 5}, {0.475f, shift * d + 0.002f, 0.475f});
        for (const Triangle& t : ear.triangles) {
            mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
        }
        mesh.vertices.insert(mesh.vertices.end(), ear.vertices.begin(), ear.vertices.end());
        std::vector<Vector3f> plate;
        for (const Vector3f& p : fillMesh(mesh, d).positions) {
            if (p.z() < 2.0f) {
                plate.push_back(p);
                EXPECT_LE(std::abs(p.y()), 0.51f * d);
                EXPECT_EQ(p.y(), plate.front().y());
            }
        }
        // Every point of the plate has a particle within half a cell's diagonal and the half diameter upwards.
        for (float x = -0.95f; x <= 0.95f; x += 0.05f) {
            for (float z = -0.95f; z <= 0.95f; z += 0.05f) {
                const Vector3f q(x, 0, z);
                EXPECT_TRUE(std::any_of(plate.begin(), plate.end(),
                                        [&](const Vector3f& p) { return (p - q).norm() < 0.9f * d; }));
            }
        }
        EXPECT_LE(plate.size(), 21u * 21u);
    }
}

TEST(Voxelize, rodThinnerThanAParticleIsAnUnbrokenRow)
{
    const Vector3f direction = Vector3f(1, 0.6f, 0.3f).normalized();
    TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 0.01f, 0.01f});
    const Eigen::Quaternionf turn = Eigen::Quaternionf::FromTwoVectors(Vector3f::UnitX(), direction);
    for (Vector3f& v : mesh.vertices) {
        v = turn * v;
    }
    const Voxels voxels = fillMesh(mesh, 0.1f);
    for (float t = -0.98f; t < 0.98f; t += 0.02f) {
        EXPECT_TRUE(std::any_of(voxels.positions.begin(), voxels.positions.end(), [&](const Vector3f& p) {
            return (p - t * direction).norm() < 0.095f;
        })) << t;
    }
}

TEST(Voxelize, twoRunsGiveTheSameBits)
{
    const TriangleMesh mesh = sphereMesh(0.7f);
    const Voxels a = fillMesh(mesh, 0.06f), b = fillMesh(mesh, 0.06f);
    EXPECT_EQ(a.positions, b.positions);
    EXPECT_EQ(a.signedDistances, b.signedDistances);
}

TEST(Voxelize, badDiametersAreRefused)
{
    const TriangleMesh mesh = sphereMesh(1.0f);
    for (const float diameter : {1e-9f, 0.005f}) EXPECT_THROW(fillMesh(mesh, diameter), InputError) << diameter;
    for (const float diameter : {-0.1f, std::nanf("")})
        EXPECT_THROW(fillMesh(mesh, diameter), std::logic_error) << diameter;
    EXPECT_THROW(Solid(mesh.vertices, {}), InputError);
}

}  // namespace
}  // namespace knuckle
