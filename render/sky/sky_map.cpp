#include "render/sky/sky_map.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace knuckle {

namespace {

constexpr double PI = std::numbers::pi;

/// Maps are halved to at most this many columns before they are blurred.
constexpr uint32_t BLURRED_FROM = 128;

}  // namespace

Eigen::Vector3f SkyMap::direction(uint32_t column, uint32_t row) const
{
    const double around = 2.0 * PI * (column + 0.5) / width, down = PI * (row + 0.5) / height;
    return Eigen::Vector3d(-std::sin(around) * std::sin(down), std::cos(down), std::cos(around) * std::sin(down))
        .cast<float>();
}

float SkyMap::solidAngle(uint32_t row) const
{
    const double top = PI * row / height, bottom = PI * (row + 1) / height;
    return static_cast<float>(2.0 * PI / width * (std::cos(top) - std::cos(bottom)));
}

Eigen::Vector3f SkyMap::meanOf(bool up) const
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double weights = 0.0;
    for (uint32_t row = 0; row < height; ++row)
        for (uint32_t column = 0; column < width; ++column) {
            const float rise = direction(column, row).y(), weight = solidAngle(row) * std::max(up ? rise : -rise, 0.0f);
            sum += weight * at(column, row).cast<double>();
            weights += weight;
        }
    return (sum / std::max(weights, 1e-9)).cast<float>();
}

SkyMap halved(const SkyMap& map)
{
    SkyMap half{std::max(map.width / 2, 1u), std::max(map.height / 2, 1u), {}};
    for (uint32_t row = 0; row < half.height; ++row)
        for (uint32_t column = 0; column < half.width; ++column) {
            Eigen::Vector3f sum = Eigen::Vector3f::Zero();
            float weights = 0.0f;
            for (uint32_t k = 0; k < 4; ++k) {
                const uint32_t y = std::min(2 * row + (k >> 1), map.height - 1);
                const uint32_t x = std::min(2 * column + (k & 1), map.width - 1);
                sum += map.solidAngle(y) * map.at(x, y);
                weights += map.solidAngle(y);
            }
            half.radiance.push_back(sum / weights);
        }
    return half;
}

SkyMap blurred(const SkyMap& map, float roughness, uint32_t width)
{
    SkyMap source = map;
    while (source.width > BLURRED_FROM) source = halved(source);
    std::vector<Eigen::Vector3f> ways;
    for (uint32_t row = 0; row < source.height; ++row)
        for (uint32_t column = 0; column < source.width; ++column) ways.push_back(source.direction(column, row));
    SkyMap out{width, std::max(width / 2, 1u), {}};
    const float alpha = roughness * roughness, square = alpha * alpha;
    for (uint32_t i = 0; i < out.width * out.height; ++i) {
        const Eigen::Vector3f way = out.direction(i % out.width, i / out.width);
        Eigen::Vector3f sum = Eigen::Vector3f::Zero();
        float weights = 0.0f;
        for (size_t k = 0; k < ways.size(); ++k) {
            const float lit = ways[k].dot(way);
            if (lit <= 0.0f) continue;
            // Half-way to a direction at this cosine.
            const float facing = 0.5f * (1.0f + lit), flat = facing * (square - 1.0f) + 1.0f;
            const float weight = lit / (flat * flat) * source.solidAngle(static_cast<uint32_t>(k / source.width));
            sum += weight * source.radiance[k];
            weights += weight;
        }
        out.radiance.push_back(sum / weights);
    }
    return out;
}

}  // namespace knuckle
