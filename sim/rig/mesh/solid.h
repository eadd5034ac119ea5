#pragma once

#include <algorithm>
#include <cmath>

#include "sim/rig/mesh/triangle_tree.h"

namespace knuckle {

/// A mesh as the boundary of a solid. Refers to the mesh's arrays.
class Solid {
public:
    /// @throws InputError for a mesh that is empty or has no size.
    Solid(std::span<const Eigen::Vector3f> vertices, std::span<const Triangle> triangles);

    const Eigen::AlignedBox3f& bounds() const { return bounds_; }
    const TriangleTree& tree() const { return tree_; }
    std::span<const Eigen::Vector3f> vertices() const { return vertices_; }
    std::span<const Triangle> triangles() const { return triangles_; }
    bool inside(const Eigen::Vector3f& point) const { return tree_.inside(point); }
    /// [m], negative inside.
    float signedDistance(const Eigen::Vector3f& point) const;

    /// Calls visit(point, normal, triangle) for points all over the surface, less than `spacing` [m] apart along the
    /// edges of triangles; triangles without an area are left out. @returns the number of points: it stops above
    /// `limit`.
    template <typename Visit>
    double forEachSample(float spacing, double limit, Visit visit) const
    {
        double samples = 0.0;
        for (uint32_t t = 0; t < triangles_.size(); ++t) {
            const auto& [first, second, third] = triangles_[t];
            const Eigen::Vector3f &a = vertices_[first], ab = vertices_[second] - a, ac = vertices_[third] - a;
            const float longest = std::max({ab.norm(), ac.norm(), (ab - ac).norm()});
            const Eigen::Vector3f normal = ab.cross(ac).normalized();
            if (!normal.allFinite()) continue;
            const int n = static_cast<int>(std::ceil(longest / spacing));
            samples += 0.5 * n * (n + 1.0);
            if (samples > limit) return samples;
            for (int i = 0; i < n; ++i) {
                for (int j = 0; i + j < n; ++j) {
                    const float u = (static_cast<float>(i) + 1.0f / 3.0f) / static_cast<float>(n);
                    const float v = (static_cast<float>(j) + 1.0f / 3.0f) / static_cast<float>(n);
                    visit(a + u * ab + v * ac, normal, t);
                }
            }
        }
        return samples;
    }

private:
    std::span<const Eigen::Vector3f> vertices_;
    std::span<const Triangle> triangles_;
    Eigen::AlignedBox3f bounds_;
    TriangleTree tree_;
};

}  // namespace knuckle
