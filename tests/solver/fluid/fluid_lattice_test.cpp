#include <cmath>
#include <set>

#include "shared/constants.h"
#include "sim/solver/fluid/fluid_lattice.h"
#include "tests/solver/solver_test.h"

namespace knuckle::test {

namespace {

constexpr float CELL = 0.11f;
constexpr uint32_t CELLS = 1u << 16;

/// A box of fluid between (0, 0, 0) and `size` [m], with its surroundings.
World basin(const Vector3f& size, const std::vector<Collider>& colliders)
{
    WorldBuilder builder(0.05f);
    Material water;
    water.fluid = true;
    const uint32_t material = builder.addMaterial(water);
    const Vector3f corners[] = {Vector3f::Constant(0.05f), size - Vector3f::Constant(0.05f)};
    builder.addFluid(corners, {0, 0, 0}, material);
    for (const Collider& collider : colliders) builder.addCollider(collider);
    return builder.build();
}

Collider wall(const Vector3f& middle, const Vector3f& size)
{
    Collider collider;
    collider.shape = ColliderShape::Box;
    collider.position = middle;
    collider.halfExtents = 0.5f * size;
    return collider;
}

/// Whether each cell that a box touches, and each that is searched from there, has its own index.
bool isPlain(const FluidLattice& lattice)
{
    const Eigen::Array3f scale = Eigen::Array3f(FINE_CELLS, 1, 1) / CELL;
    const Eigen::Array3i beside(FINE_CELLS, 1, 1);
    const Eigen::Array3i low = (lattice.home.min().array() * scale).floor().cast<int>();
    const Eigen::Array3i high = (lattice.home.max().array() * scale).floor().cast<int>() + beside;
    std::vector<bool> taken(CELLS, false);
    for (int z = low.z(); z <= high.z(); ++z)
        for (int y = low.y(); y <= high.y(); ++y)
            for (int x = low.x(); x <= high.x(); ++x) {
                const uint32_t index = (static_cast<uint32_t>(x) + lattice.strideY * static_cast<uint32_t>(y) +
                                        lattice.strideZ * static_cast<uint32_t>(z)) &
                                       (CELLS - 1);
                if (taken[index]) return false;
                taken[index] = true;
            }
    return true;
}

}  // namespace

TEST(FluidLattice, ReachesToThePlanesAroundAndFarUp)
{
    const World world = basin(
        {1, 1, 1}, {planeAt({0, 0, 0}, {0, 1, 0}), planeAt({0, 0, 0}, {1, 0, 0}), planeAt({3, 0, 0}, {-1, 0, 0}),
                    planeAt({0, 0, 0}, {0, 0, 1}), planeAt({0, 0, 1}, {0, 0, -1})});
    const FluidLattice lattice = fluidLattice(world, CELL, CELLS);
    EXPECT_TRUE(lattice.home.contains(Eigen::AlignedBox3f(Vector3f(0, 0, 0), Vector3f(3, 1, 1))));
    // 136 x 16 cells and no walls above: some 30 are left.
    EXPECT_GT(lattice.home.max().y(), 2.5f);
    EXPECT_LT(lattice.home.max().x(), 3.5f);
    EXPECT_TRUE(isPlain(lattice));
}

TEST(FluidLattice, ReachesBehindWalls)
{
    const World world = basin({1, 1, 1}, {planeAt({0, 0, 0}, {0, 1, 0}), wall({-0.1f, 1, 0.5f}, {0.2f, 2, 1}),
                                          wall({2.1f, 1, 0.5f}, {0.2f, 2, 1}), wall({1, 1, -0.1f}, {2, 2, 0.2f}),
                                          wall({1, 1, 1.1f}, {2, 2, 0.2f})});
    const FluidLattice lattice = fluidLattice(world, CELL, CELLS);
    EXPECT_TRUE(lattice.home.contains(Eigen::AlignedBox3f(Vector3f(-0.2f, 0, -0.2f), Vector3f(2.2f, 1, 1.2f))));
    EXPECT_GT(lattice.home.max().y(), 2.0f);
    EXPECT_TRUE(isPlain(lattice));
}

TEST(FluidLattice, GrowsToAllSidesWhereNothingIsAround)
{
    const FluidLattice lattice = fluidLattice(basin({1, 0.5f, 1}, {}), CELL, CELLS);
    const Vector3f below = -lattice.home.min(), above = lattice.home.max() - Vector3f(1, 0.5f, 1);
    EXPECT_GT(below.minCoeff(), 0.5f);
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(below[axis], below.x(), 1e-3f);
        EXPECT_NEAR(above[axis], below.x(), 1e-3f);
    }
    EXPECT_TRUE(isPlain(lattice));
}

TEST(FluidLattice, IsTheMiddleOfWhatIsTooWideForIt)
{
    const FluidLattice lattice = fluidLattice(basin({40, 2, 40}, {}), CELL, CELLS);
    EXPECT_TRUE(lattice.home.center().isApprox(Vector3f(20, 1, 20), 1e-3f));
    EXPECT_LT(lattice.home.sizes().x(), 39.0f);
    EXPECT_GT(lattice.home.sizes().x(), 2.0f);
    EXPECT_TRUE(isPlain(lattice));
}

}  // namespace knuckle::test
