#include "render/compare/flip/flip_tile.h"

#include <numbers>

namespace knuckle {

namespace {

// The paper's q_c, p_c, p_t and q_f.
constexpr float COLOR_EXPONENT = 0.7f;
/// Differences up to this share of the largest are spread over the errors up to MODERATE_ERROR.
constexpr float MODERATE_SHARE = 0.4f, MODERATE_ERROR = 0.95f;
constexpr float FEATURE_EXPONENT = 0.5f;

float colorError(float distance, float largest)
{
    const float moderate = MODERATE_SHARE * largest, power = std::pow(distance, COLOR_EXPONENT);
    if (power < moderate) return MODERATE_ERROR / moderate * power;
    return MODERATE_ERROR + (power - moderate) / (largest - moderate) * (1.0f - MODERATE_ERROR);
}

}  // namespace

FlipTile::FlipTile(const FlipFilters& filters)
    : filters_(filters),
      largestDistance_(std::pow(hyabDistance(huntLabOfRgb({0, 1, 0}), huntLabOfRgb({0, 0, 1})), COLOR_EXPONENT))
{
}

const Plane& FlipTile::errors(LightTile& a, LightTile& b)
{
    see(a, a_);
    see(b, b_);
    errors_.resize(a_.edge.width, a_.edge.height);
    for (size_t i = 0; i < errors_.values.size(); ++i) {
        const auto color = [i](const Seen& seen) {
            return Color{seen.colors[0].values[i], seen.colors[1].values[i], seen.colors[2].values[i]};
        };
        const float distance = hyabDistance(color(a_), color(b_));
        const float edges = std::fabs(a_.edge.values[i] - b_.edge.values[i]);
        const float points = std::fabs(a_.point.values[i] - b_.point.values[i]);
        const float feature = std::pow(std::max(edges, points) / std::numbers::sqrt2_v<float>, FEATURE_EXPONENT);
        errors_.values[i] = distance > 0.0f
                                ? std::pow(std::min(1.0f, colorError(distance, largestDistance_)), 1.0f - feature)
                                : 0.0f;
    }
    return errors_;
}

void FlipTile::see(LightTile& light, Seen& seen)
{
    for (size_t i = 0; i < light[0].values.size(); ++i) {
        const Color opponent = opponentOfRgb({light[0].values[i], light[1].values[i], light[2].values[i]});
        for (size_t c = 0; c < 3; ++c) light[c].values[i] = opponent[c];
    }
    filterColors(light, seen.colors);
    filterRows(light[0], filters_.smooth, filters_.reach, smoothed_);
    findFeatures(light[0], filters_.edge, smoothed_, seen.edge);
    findFeatures(light[0], filters_.point, smoothed_, seen.point);
}

void FlipTile::filterColors(const LightTile& opponent, LightTile& colors)
{
    const uint32_t reach = filters_.reach;
    const auto filter = [&](size_t channel, const std::vector<float>& kernel, float weight, bool add) {
        filterRows(opponent[channel], kernel, reach, rows_);
        filterColumns(rows_, kernel, reach, weight, add, colors[channel]);
    };
    filter(0, filters_.brightness, 1.0f, false);
    filter(1, filters_.redGreen, 1.0f, false);
    filter(2, filters_.blueYellow, filters_.blueYellowWeight, false);
    filter(2, filters_.blueYellowNarrow, filters_.blueYellowNarrowWeight, true);
    for (size_t i = 0; i < colors[0].values.size(); ++i) {
        Color rgb = rgbOfOpponent({colors[0].values[i], colors[1].values[i], colors[2].values[i]});
        for (float& part : rgb) part = std::clamp(part, 0.0f, 1.0f);
        const Color lab = huntLabOfRgb(rgb);
        for (size_t c = 0; c < 3; ++c) colors[c].values[i] = lab[c];
    }
}

void FlipTile::findFeatures(const Plane& brightness, const std::vector<float>& along, const Plane& smoothed,
                            Plane& strength)
{
    const uint32_t reach = filters_.reach;
    filterRows(brightness, along, reach, rows_);
    filterColumns(rows_, filters_.smooth, reach, 1.0f / 116.0f, false, strength);
    filterColumns(smoothed, along, reach, 1.0f / 116.0f, false, across_);
    for (size_t i = 0; i < strength.values.size(); ++i) {
        const float x = strength.values[i], y = across_.values[i];
        strength.values[i] = std::sqrt(x * x + y * y);
    }
}

}  // namespace knuckle
