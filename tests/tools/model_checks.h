#pragma once

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <utility>

#include "sim/rig/gltf/glb.h"
#include "sim/rig/model.h"
#include "tests/places.h"

namespace knuckle::test {

/// The number of edges between places of a mesh that are not passed equally often both ways: 0 if it is closed.
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

/// Expects assets/models to have the model as the code makes it.
inline void expectCommitted(const std::string& name, const Model& model)
{
    const std::string path = "assets/models/" + name + ".glb";
    std::ifstream file(inSource(path), std::ios::binary);
    const std::string committed{std::istreambuf_iterator<char>(file), {}};
    EXPECT_TRUE(committed == toGlb(model)) << "make it again: build/release/bin/make_model " << name << " " << path;
    EXPECT_LT(committed.size(), 1600000u);
}

}  // namespace knuckle::test
