#include "sim/solver/fluid/fluid_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shared/constants.h"
#include "sim/world/space/bounds.h"

namespace knuckle {

namespace {

using Eigen::AlignedBox3f;

constexpr float INF = std::numeric_limits<float>::infinity();

/// Moves a face of `limits` inwards to a plane that faces along an axis.
void limitAt(AlignedBox3f& limits, const Collider& plane)
{
    const Vector3f normal = plane.orientation * Vector3f::UnitY();
    for (int axis = 0; axis < 3; ++axis) {
        if (normal[axis] > 0.999f) limits.min()[axis] = std::max(limits.min()[axis], plane.position[axis]);
        if (normal[axis] < -0.999f) limits.max()[axis] = std::min(limits.max()[axis], plane.position[axis]);
    }
}

/// The same for a box collider that covers at least half of a face of `limits`: the face moves to the wall's far side.
void limitAt(AlignedBox3f& limits, const AlignedBox3f& box, const AlignedBox3f& wall)
{
    const Vector3f common = box.intersection(wall).sizes();
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        if (common[u] < 0.5f * box.sizes()[u] || common[v] < 0.5f * box.sizes()[v]) continue;
        if (wall.center()[axis] <= box.min()[axis]) limits.min()[axis] = std::max(limits.min()[axis], wall.min()[axis]);
        if (wall.center()[axis] >= box.max()[axis]) limits.max()[axis] = std::min(limits.max()[axis], wall.max()[axis]);
    }
}

/// The box that particles cannot leave without passing a wall, and a margin, as predictions may lie behind a wall.
AlignedBox3f limitsOf(const World& world, const AlignedBox3f& box, float margin)
{
    AlignedBox3f limits(Vector3f::Constant(-INF), Vector3f::Constant(INF));
    for (const Collider& collider : world.colliders)
        if (collider.shape == ColliderShape::Plane) limitAt(limits, collider);
        else limitAt(limits, box, colliderBounds(world, collider));
    const AlignedBox3f all = limits.merged(box);  // the box always contains the particles themselves
    return {all.min() - Vector3f::Constant(margin), all.max() + Vector3f::Constant(margin)};
}

/// Number of cells along each axis that a box covers, with those beside them that a search reaches.
Eigen::Vector3d cellsOf(const AlignedBox3f& box, float cell)
{
    const Eigen::Vector3d sizes = box.sizes().cast<double>() / cell;
    return {std::ceil(FINE_CELLS * sizes.x()) + 1 + FINE_CELLS, std::ceil(sizes.y()) + 2, std::ceil(sizes.z()) + 2};
}

/// The largest box of a growing family boxOf(0) .. boxOf(1) for which the cells suffice.
template <class Family>
AlignedBox3f largest(float cell, uint32_t cells, const Family& boxOf)
{
    double low = 0.0, high = 1.0;
    for (int k = 0; k < 40; ++k) {
        const double middle = 0.5 * (low + high);
        (cellsOf(boxOf(static_cast<float>(middle)), cell).prod() <= cells ? low : high) = middle;
    }
    return boxOf(static_cast<float>(low));
}

}  // namespace

FluidLattice fluidLattice(const World& world, float cell, uint32_t cells)
{
    const AlignedBox3f box = particleBounds(world), limits = limitsOf(world, box, 2.0f * cell);
    const float most = cell * static_cast<float>(cells);
    const auto grown = [&](const AlignedBox3f& from, float way) {
        const Vector3f all = Vector3f::Constant(way * most);
        return AlignedBox3f(from.min() - all, from.max() + all);
    };
    FluidLattice lattice;
    lattice.home = largest(cell, cells, [&](float share) {
        return AlignedBox3f(box.center() - 0.5f * share * box.sizes(), box.center() + 0.5f * share * box.sizes());
    });
    if (lattice.home.sizes().isApprox(box.sizes(), 1e-5f)) {
        const AlignedBox3f within = largest(cell, cells,
                                            [&](float way) { return grown(box, way).intersection(limits); });
        lattice.home = largest(cell, cells, [&](float way) { return grown(within, way); });
    }
    const Eigen::Vector3d counts = cellsOf(lattice.home, cell);
    lattice.strideY = static_cast<uint32_t>(counts.x());
    lattice.strideZ = static_cast<uint32_t>(counts.x() * counts.y());
    return lattice;
}

}  // namespace knuckle
