#pragma once

#include <Eigen/Core>
#include <cmath>
#include <numbers>
#include <vector>

namespace knuckle::test {

/// Unit vectors all over the sphere, densely about the axes, up to a distance of 1e-9 from them.
inline std::vector<Eigen::Vector3f> directions()
{
    std::vector<Eigen::Vector3f> all;
    constexpr int COUNT = 1000;
    for (int i = 0; i < COUNT; ++i) {
        const float y = 1.0f - 2.0f * (static_cast<float>(i) + 0.5f) / COUNT, r = std::sqrt(1.0f - y * y);
        const float turn = 2.399963f * static_cast<float>(i);
        all.emplace_back(r * std::cos(turn), y, r * std::sin(turn));
    }
    for (int axis = 0; axis < 3; ++axis) {
        for (const float sign : {1.0f, -1.0f}) {
            all.emplace_back(sign * Eigen::Vector3f::Unit(axis));
            for (float off = 0.1f; off > 1e-9f; off *= 0.7f) {
                for (int k = 0; k < 5; ++k) {
                    const float turn = 0.4f + 2.0f * std::numbers::pi_v<float> * static_cast<float>(k) / 5.0f;
                    Eigen::Vector3f way = sign * Eigen::Vector3f::Unit(axis);
                    way[(axis + 1) % 3] = off * std::cos(turn);
                    way[(axis + 2) % 3] = off * std::sin(turn);
                    all.push_back(way.normalized());
                }
            }
        }
    }
    return all;
}

}  // namespace knuckle::test
