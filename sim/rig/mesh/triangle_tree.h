#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

using Triangle = std::array<uint32_t, 3>;  ///< Vertex indices, counter-clockwise seen from outside.

struct TriangleMesh {
    std::vector<Eigen::Vector3f> vertices;
    std::vector<Triangle> triangles;
};

/// The point of a mesh nearest to a query.
struct SurfacePoint {
    uint32_t triangle = NO_INDEX;
    Eigen::Vector3f barycentric{0, 0, 0};  ///< Weights of the triangle's three vertices.
    Eigen::Vector3f position{0, 0, 0};
    float distance = 0.0f;  ///< From the query [the mesh's unit], >= 0.
};

/// A bounding volume hierarchy over triangles, for nearest points and generalized winding numbers.
class TriangleTree {
public:
    /// Indices must be in range and positions finite. Triangles may be degenerate and the mesh open.
    TriangleTree(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles);

    bool empty() const { return nodes_.empty(); }

    /// Generalized winding number: about 1 inside a closed mesh, 0 outside, in between near holes. Clusters of
    /// triangles far from the point count as one dipole (Barill et al. 2018, eq. 8, first term); near ones exactly.
    double windingNumber(const Eigen::Vector3f& point) const;
    /// Inside by winding number, whichever way round the triangles are.
    bool inside(const Eigen::Vector3f& point) const;
    /// The nearest point of the surface. The tree must not be empty. Ties go to the triangle met first.
    SurfacePoint nearest(const Eigen::Vector3f& point) const;
    /// The same, but of surfaces that coincide, the one whose inside contains the point.
    SurfacePoint nearestAround(const Eigen::Vector3f& point) const;

private:
    struct Node {
        Eigen::Vector3f low, high;      // bounds
        Eigen::Vector3f centre;         // area-weighted mean of the triangles' centroids
        Eigen::Vector3f areaNormal;     // sum of area times normal
        float reach = 0.0f;             // greatest distance of a vertex from centre
        uint32_t first = 0, count = 0;  // triangles of a leaf, in order_
        uint32_t right = 0;             // the left child follows its parent
    };

    uint32_t build(uint32_t first, uint32_t count);
    void summarize(Node& node, uint32_t first, uint32_t count) const;
    std::array<Eigen::Vector3f, 3> corners(uint32_t triangle) const;
    /// The nearest point of accepted triangles, nearer than `reach`; NO_INDEX for none.
    template <typename Accept>
    SurfacePoint search(const Eigen::Vector3f& point, float reach, Accept accept) const;

    std::span<const Eigen::Vector3f> vertices_;
    std::span<const Triangle> triangles_;
    std::vector<uint32_t> order_;
    std::vector<Eigen::Vector3f> centroids_;
    std::vector<Node> nodes_;
};

/// Signed solid angle of a triangle seen from `point` over 4 pi (Van Oosterom and Strackee 1983).
double solidAngle(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& point);
/// Weights of the three corners at the point of the triangle nearest to `point` (Ericson 2005, section 5.1.5).
Eigen::Vector3f nearestInTriangle(const std::array<Eigen::Vector3f, 3>& corners, const Eigen::Vector3f& point);

}  // namespace knuckle
