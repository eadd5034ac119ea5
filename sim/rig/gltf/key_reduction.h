#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace knuckle {

/// Indices of keys whose linear interpolation is nowhere further than `tolerance` [m] from the keys between; the first
/// and the last are always among them. @param times ascending [s].
std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Vector3f> values, float tolerance);
/// The same for turns, by angle [rad]; interpolated like in glTF viewers, spherically the shorter way.
std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Quaternionf> values, float tolerance);

}  // namespace knuckle
