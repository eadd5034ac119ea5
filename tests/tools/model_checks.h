#pragma once

#include <array>
#include <map>
#include <utility>

#include "sim/actor/import/model.h"

namespace knuckle::test {

/// How many edges between places of a mesh are not passed as often one way as the other: 0 where it is closed.
inline size_t openEdges(const Model& model)
{
    using Place = std::array<float, 3>;
    std::map<std::pair<Place, Place>, int> edges;
    for (const auto& triangle : model.triangles) {
        std::array<Place, 3> corners;
        for (size_t i = 0; i < 3; ++i) {
            const Eigen::Vector3f& v = model.vertices[triangle[i]];
            corners[i] = {v.x(), v.y(), v.z()};
        }
        for (size_t i = 0; i < 3; ++i) {
            ++edges[{corners[i], corners[(i + 1) % 3]}];
            --edges[{corners[(i + 1) % 3], corners[i]}];
        }
    }
    size_t open = 0;
    for (const auto& [edge, balance] : edges) open += balance != 0 ? 1 : 0;
    return open;
}

}  // namespace knuckle::test
