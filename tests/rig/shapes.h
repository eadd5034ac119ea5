#pragma once

#include <cmath>
#include <numbers>

#include "sim/rig/mesh/triangle_tree.h"

namespace knuckle {

/// A box around `centre`, its sides pointing outwards; `open` leaves the +y side out.
inline TriangleMesh boxMesh(const Eigen::Vector3f& centre, const Eigen::Vector3f& half, bool open = false)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3f sign((i & 1) ? 1.0f : -1.0f, (i & 2) ? 1.0f : -1.0f, (i & 4) ? 1.0f : -1.0f);
        mesh.vertices.push_back(centre + half.cwiseProduct(sign));
    }
    mesh.triangles = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}, {0, 1, 5},
                      {0, 5, 4}, {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};
    if (!open) {
        mesh.triangles.push_back({2, 6, 7});
        mesh.triangles.push_back({2, 7, 3});
    }
    return mesh;
}

/// A sphere of the radius around the origin.
inline TriangleMesh sphereMesh(float radius, int rings = 24)
{
    TriangleMesh mesh;
    const int sides = 2 * rings;
    for (int r = 0; r <= rings; ++r) {
        for (int s = 0; s < sides; ++s) {
            const float a = std::numbers::pi_v<float> * static_cast<float>(r) / static_cast<float>(rings);
            const float b = 2.0f * std::numbers::pi_v<float> * static_cast<float>(s) / static_cast<float>(sides);
            mesh.vertices.emplace_back(radius * std::sin(a) * std::cos(b), radius * std::cos(a),
                                       -radius * std::sin(a) * std::sin(b));
        }
    }
    for (int r = 0; r < rings; ++r) {
        for (int s = 0; s < sides; ++s) {
            const auto at = [&](int ring, int side) { return static_cast<uint32_t>(ring * sides + side % sides); };
            mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
            mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
        }
    }
    return mesh;
}

}  // namespace knuckle
