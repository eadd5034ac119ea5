#include "sim/rig/limbs/limb_lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace knuckle {

using Eigen::Vector2f;
using Eigen::Vector3f;

const std::vector<SlicePattern> SLICE_PATTERNS{
    {true, {0.0f, 0.0f}}, {true, {0.5f, 0.2887f}}, {false, {0.0f, 0.0f}}, {false, {0.5f, 0.5f}}, {false, {0.0f, 0.5f}},
};

namespace {

/// Distances between particles in a lattice: along the bone, in a row, and between rows [m].
struct Spacing {
    float along, inRow, ofRows;
};

Spacing spacingOf(const LimbFrame& frame, const SlicePattern& pattern, float diameter)
{
    Spacing spacing{};
    const float slices = std::max(std::round(frame.length() / diameter), 1.0f);
    spacing.along = frame.leaf ? diameter : frame.length() / slices;
    const float area = diameter * diameter * diameter / spacing.along;
    // A triangular lattice has sqrt(3) / 2 of the area of a square one of equal spacing.
    spacing.inRow = std::sqrt(pattern.hexagonal ? area / 0.8660254f : area);
    spacing.ofRows = area / spacing.inRow;
    return spacing;
}

/// Places of particles in a slice, up to `radius` from the bone [m].
std::vector<Vector2f> slicePlaces(const SlicePattern& pattern, const Spacing& spacing, float radius)
{
    std::vector<Vector2f> places;
    const int rows = static_cast<int>(std::ceil(radius / spacing.ofRows)) + 1;
    const int columns = static_cast<int>(std::ceil(radius / spacing.inRow)) + 1;
    for (int row = -rows; row <= rows; ++row) {
        for (int column = -columns; column <= columns; ++column) {
            const float stagger = pattern.hexagonal && row % 2 != 0 ? 0.5f : 0.0f;
            const Vector2f place((static_cast<float>(column) + stagger + pattern.shift.x()) * spacing.inRow,
                                 static_cast<float>(row) * spacing.ofRows +
                                     pattern.shift.y() * (pattern.hexagonal ? spacing.inRow : spacing.ofRows));
            if (place.norm() <= radius) places.push_back(place);
        }
    }
    return places;
}

}  // namespace

std::vector<Vector3f> limbPlaces(const LimbFrame& frame, const SlicePattern& pattern, float diameter,
                                 const std::function<bool(const Vector3f&)>& belongs)
{
    const Spacing spacing = spacingOf(frame, pattern, diameter);
    const std::vector<Vector2f> slice = slicePlaces(pattern, spacing, frame.radius);
    const Vector3f along = frame.along(), row = along.cross(frame.across);
    const int first = -static_cast<int>(std::ceil(frame.before / spacing.along));
    const int last = static_cast<int>(std::ceil((frame.length() + frame.after) / spacing.along));
    std::vector<Vector3f> places;
    for (int k = first; k <= last; ++k) {
        const Vector3f middle = frame.head + static_cast<float>(k) * spacing.along * along;
        for (const Vector2f& place : slice) {
            const Vector3f position = middle + place.x() * row + place.y() * frame.across;
            if (belongs(position)) places.push_back(position);
        }
    }
    return places;
}

float surfaceError(const std::vector<Vector3f>& particles, const std::vector<Vector3f>& surface, float diameter)
{
    double sum = 0.0;
    for (const Vector3f& point : surface) {
        float nearest = std::numeric_limits<float>::infinity();
        for (const Vector3f& particle : particles) nearest = std::min(nearest, (particle - point).squaredNorm());
        const double miss = std::sqrt(nearest) / diameter - 0.5;
        sum += miss * miss;
    }
    return surface.empty() ? 0.0f : static_cast<float>(std::sqrt(sum / static_cast<double>(surface.size())));
}

}  // namespace knuckle
