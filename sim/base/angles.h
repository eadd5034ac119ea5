#pragma once

#include <numbers>

namespace knuckle {

/// Degrees times this are radians.
inline constexpr float DEGREE = std::numbers::pi_v<float> / 180;
/// Half a turn [rad]: limits this wide to both sides do not limit.
inline constexpr float HALF_TURN = std::numbers::pi_v<float>;
inline constexpr float WHOLE_TURN = 2 * std::numbers::pi_v<float>;

/// Exact at half a turn, unlike DEGREE.
constexpr float radiansOf(float degrees)
{
    return degrees / 180 * HALF_TURN;
}
constexpr double degreesOf(float radians)
{
    return double{radians} / std::numbers::pi * 180;
}

}  // namespace knuckle
