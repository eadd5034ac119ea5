#include "sim/rig/mesh/voxelize.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <stdexcept>

#include "sim/base/errors.h"
#include "sim/rig/mesh/polyhedron.h"

namespace knuckle {

using Eigen::Vector3f;
using Eigen::Vector3i;

namespace {

constexpr double CELL_LIMIT = 5e7;         // lattice points looked at
constexpr double SAMPLE_LIMIT = 2e7;       // surface samples looked at
constexpr float DEFAULT_DIAMETER = 0.03f;  // of the longest side

// The cubic lattice over a mesh, and its points that are taken.
class Lattice {
public:
    Lattice(const Eigen::AlignedBox3f& bounds, const Vector3f& centre, float spacing) : spacing_(spacing)
    {
        const Vector3f half = (bounds.max() - centre).cwiseMax(centre - bounds.min());
        // One point beyond the bounds on each side, since a thin part's layer may be outside.
        const Eigen::Vector3d reach = (half / spacing).cast<double>().array().ceil() + 1.0;
        const double cells = (2.0 * reach.array() + 1.0).prod();
        if (!(cells <= CELL_LIMIT)) {
            throw InputError(fmt::format(
                "particle diameter {:g} m is too small for a model of {:.3g} x {:.3g} x {:.3g} m: use a larger one",
                spacing, bounds.sizes().x(), bounds.sizes().y(), bounds.sizes().z()));
        }
        counts_ = 2 * reach.cast<int>() + Vector3i::Ones();
        origin_ = centre - spacing * reach.cast<float>();
        taken_.assign(static_cast<size_t>(counts_.prod()), 0);
    }

    size_t index(const Vector3i& cell) const
    {
        return (static_cast<size_t>(cell.z()) * counts_.y() + cell.y()) * counts_.x() + cell.x();
    }
    Vector3f position(const Vector3i& cell) const { return origin_ + spacing_ * cell.cast<float>(); }
    // Rounds slightly downwards: for a plate midway between two layers of the lattice, all points go to the same layer.
    Vector3i round(const Vector3f& p) const
    {
        const Vector3f cell = ((p - origin_) / spacing_).array() + 0.45f;
        return cell.array().floor().cast<int>().cwiseMax(1).matrix().cwiseMin(counts_ - 2 * Vector3i::Ones());
    }
    bool taken(const Vector3i& cell) const { return taken_[index(cell)] != 0; }
    void take(const Vector3i& cell)
    {
        count_ += taken(cell) ? 0 : 1;
        taken_[index(cell)] = 1;
    }
    // Whether a taken point is nearer to p than `reach` (below one spacing).
    bool covered(const Vector3f& p, float reach) const
    {
        const Vector3i centre = round(p);
        for (int i = 0; i < 27; ++i) {
            const Vector3i cell = centre + Vector3i(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
            if (taken(cell) && (position(cell) - p).norm() < reach) {
                return true;
            }
        }
        return false;
    }

    template <typename Visit>
    void forEach(Visit visit) const
    {
        forEachIn(Vector3i::Zero(), counts_, 1, visit);
    }
    // The points from `low` to before `high`, every step-th along each axis.
    template <typename Visit>
    void forEachIn(const Vector3i& low, const Vector3i& high, int step, Visit visit) const
    {
        for (int z = low.z(); z < high.z(); z += step)
            for (int y = low.y(); y < high.y(); y += step)
                for (int x = low.x(); x < high.x(); x += step) visit(Vector3i(x, y, z));
    }
    const Vector3i& counts() const { return counts_; }
    size_t count() const { return count_; }
    float spacing() const { return spacing_; }

private:
    float spacing_;
    Vector3i counts_;
    Vector3f origin_;
    std::vector<uint8_t> taken_;
    size_t count_ = 0;
};

// Depths behind the surface at which the solid is probed [d]. A part deeper than the last holds lattice points anyway.
constexpr float PROBES[] = {0.03f, 0.06f, 0.12f, 0.25f, 0.5f, 0.75f, 1.0f, 1.25f, 1.5f, 1.75f};
constexpr float DEEPEST = PROBES[std::size(PROBES) - 1];

// The depth of the solid behind a surface sample, at most DEEPEST [d]; 0 for an open sheet.
float probeDepth(const TriangleTree& tree, const Vector3f& sample, const Vector3f& inward, float diameter)
{
    float depth = 0.0f;
    for (const float probe : PROBES) {
        if (!tree.inside(sample + probe * diameter * inward)) {
            break;
        }
        depth = probe;
    }
    return depth;
}

// Takes the lattice point nearest to the middle of a part that is too thin for the lattice, if none is taken there.
void keepThinPart(Lattice& lattice, const TriangleTree& tree, const Vector3f& sample, const Vector3f& normal)
{
    const float d = lattice.spacing();
    // Most samples end here: a taken point is just behind them.
    if (lattice.covered(sample - 0.5f * d * normal, 0.75f * d) || lattice.covered(sample, 0.5f * d)) {
        return;
    }
    for (const float side : {-1.0f, 1.0f}) {
        const float depth = probeDepth(tree, sample, side * normal, d);
        if (depth >= DEEPEST) {
            return;
        }
        if (depth > 0.0f || side > 0.0f) {
            const Vector3f middle = sample + 0.5f * depth * d * side * normal;
            // Half the diagonal of a cell is 0.87: with less, no point might cover the middle of a cell.
            if (!lattice.covered(middle, 0.9f * d)) {
                lattice.take(lattice.round(middle));
            }
            return;
        }
    }
}

// Walks over the surface in samples at most half a diameter apart.
void keepThinParts(Lattice& lattice, const Solid& solid)
{
    const double samples = solid.forEachSample(0.5f * lattice.spacing(), SAMPLE_LIMIT,
                                               [&](const Vector3f& sample, const Vector3f& normal, uint32_t) {
                                                   keepThinPart(lattice, solid.tree(), sample, normal);
                                               });
    if (samples > SAMPLE_LIMIT)
        throw InputError(fmt::format("particle diameter {:g} m is too small for this model's surface: use a larger one",
                                     lattice.spacing()));
}

// Points of the lattice along each axis that are tested together if no surface is among them.
constexpr int BLOCK = 4;
// Distance from a whole number, for a winding number with no hole nearby.
constexpr double CLOSED = 0.05;

// Whether everything within `reach` of the middle is inside, or everything outside.
bool isAllOrNothing(const TriangleTree& tree, const Vector3f& middle, float reach)
{
    if (tree.nearest(middle).distance <= reach) return false;
    const double number = tree.windingNumber(middle);
    return std::abs(number - std::round(number)) < CLOSED;
}

Lattice fill(const Solid& solid, const VoxelOptions& options, float diameter)
{
    const TriangleTree& tree = solid.tree();
    Lattice lattice(solid.bounds(), options.centre.value_or(solid.bounds().center()), diameter);
    lattice.forEachIn(Vector3i::Zero(), lattice.counts(), BLOCK, [&](const Vector3i& low) {
        const Vector3i high = (low + Vector3i::Constant(BLOCK)).cwiseMin(lattice.counts());
        const Vector3f middle = 0.5f * (lattice.position(low) + lattice.position(high - Vector3i::Ones()));
        const bool whole = isAllOrNothing(tree, middle, (middle - lattice.position(low)).norm());
        if (whole && !tree.inside(middle)) return;
        lattice.forEachIn(low, high, 1, [&](const Vector3i& cell) {
            if (whole || tree.inside(lattice.position(cell))) lattice.take(cell);
        });
    });
    keepThinParts(lattice, solid);
    return lattice;
}

// Extra depth [d] half a diameter inwards, from which a side counts as the only nearest one.
constexpr float DEEPER = 0.15f;

Vector3f outwardOf(const Solid& solid, const Vector3f& point, float distance, const Vector3f& nearest, float diameter)
{
    if (std::abs(distance) < 1e-3f * diameter) {
        return Vector3f::Zero();
    }
    const Vector3f outward = (point - nearest) / distance;
    const bool deeper = solid.signedDistance(point - 0.5f * diameter * outward) < distance - DEEPER * diameter;
    return deeper ? outward : Vector3f(Vector3f::Zero());
}

float chooseDiameter(const Solid& solid, const VoxelOptions& options)
{
    if (options.diameter == 0.0f) return DEFAULT_DIAMETER * solid.bounds().sizes().maxCoeff();
    if (!(options.diameter > 0.0f) || !std::isfinite(options.diameter))
        throw std::logic_error(fmt::format("particle diameter must be a length above 0 m, not {}", options.diameter));
    return options.diameter;
}

}  // namespace

void Voxels::add(const Solid& solid, const Vector3f& position)
{
    const SurfacePoint point = solid.tree().nearest(position);
    const float distance = solid.inside(position) ? -point.distance : point.distance;
    positions.push_back(position);
    nearest.push_back(point);
    signedDistances.push_back(distance);
    outward.push_back(outwardOf(solid, position, distance, point.position, diameter));
}

Voxels Voxels::chosen(std::span<const uint32_t> particles) const
{
    Voxels some;
    some.diameter = diameter;
    for (const uint32_t p : particles) {
        some.positions.push_back(positions[p]);
        some.nearest.push_back(nearest[p]);
        some.signedDistances.push_back(signedDistances[p]);
        some.outward.push_back(outward[p]);
    }
    return some;
}

Voxels voxelize(const Solid& solid, const VoxelOptions& options)
{
    Voxels voxels;
    voxels.diameter = chooseDiameter(solid, options);
    if (options.facets) {
        const std::vector<Facet> facets = facetsOf(solid);
        if (!isBoxAlongAxes(facets))
            for (const Vector3f& place : fillPolyhedron(facets, voxels.diameter)) voxels.add(solid, place);
        if (!voxels.positions.empty()) return voxels;
    }
    const Lattice lattice = fill(solid, options, voxels.diameter);
    if (lattice.count() > options.particleLimit) {
        const double factor = std::cbrt(static_cast<double>(lattice.count()) / options.particleLimit);
        throw InputError(fmt::format("diameter {:g} m fills the model with {} particles, at most {} are allowed: "
                                     "use {:.2g} m or more",
                                     voxels.diameter, lattice.count(), options.particleLimit,
                                     1.05 * factor * voxels.diameter));
    }
    lattice.forEach([&](const Vector3i& cell) {
        if (lattice.taken(cell)) voxels.add(solid, lattice.position(cell));
    });
    if (voxels.positions.empty()) {
        throw InputError(
            fmt::format("no particle of {:g} m fits into the model: use a smaller diameter", voxels.diameter));
    }
    return voxels;
}

}  // namespace knuckle
