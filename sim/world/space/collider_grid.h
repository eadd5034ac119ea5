#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace knuckle {

/// Most values of a grid.
inline constexpr uint64_t MAX_GRID_VALUES = 4'000'000;

/// Data of a collider of the shape Mesh or Heightfield, in the collider's own frame. Values are at low + cell * (x, y,
/// z), x fastest, then y, then z.
///
/// Mesh: signed distances to its surface [m], negative inside, with at least a cell of positive ones all around.
/// Heightfield: heights over y = 0 [m]; counts.y is 1 and low.y 0.
struct ColliderGrid {
    Eigen::Vector3f low{0, 0, 0};     ///< [m]
    Eigen::Vector3f cell{1, 1, 1};    ///< [m], > 0; of a mesh equal on all axes.
    Eigen::Vector3i counts{2, 2, 2};  ///< At least 2 on each axis that has values.
    std::vector<float> values;
    std::vector<Eigen::Vector3f> vertices;                  ///< For drawing.
    std::vector<std::array<uint32_t, 3>> triangles;         ///< Counter-clockwise seen from outside.
    Eigen::Vector3f drawnLow{0, 0, 0}, drawnHigh{0, 0, 0};  ///< Bounds of the vertices [m].

    size_t index(int x, int y, int z) const
    {
        return (static_cast<size_t>(z) * static_cast<size_t>(counts.y()) + static_cast<size_t>(y)) *
                   static_cast<size_t>(counts.x()) +
               static_cast<size_t>(x);
    }
    /// Sets the bounds from the vertices.
    void findBounds();
};

/// Signed distance of a point to a mesh, by trilinear interpolation of its grid; outside the grid the distance to the
/// point of the surface that is nearest to where the grid ends [m].
float meshDistance(const ColliderGrid& grid, const Eigen::Vector3f& point);

/// Signed distance of a point to the plane that touches the bilinear surface above or below it; beyond the field's
/// edge, to the block below the field [m].
float heightfieldDistance(const ColliderGrid& grid, const Eigen::Vector3f& point);

/// A heightfield about the origin, over size.x by size.y [m] along x and z. @param heights [m], rows along x, that of
/// the lowest z first. Its triangles have the same heights at the values.
ColliderGrid makeHeightfield(const Eigen::Vector2f& size, int columns, int rows, std::vector<float> heights);

}  // namespace knuckle
