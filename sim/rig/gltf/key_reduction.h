#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace knuckle {

/// Indices of the keys between which linear interpolation is nowhere farther from what lies between than `tolerance`
/// [m]; the first and the last are always among them. @param times ascending [s].
std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Vector3f> values, float tolerance);
/// The same of turns, by angle [rad]; interpolated as glTF viewers do, spherically the shorter way.
std::vector<size_t> keysOf(std::span<const float> times, std::span<const Eigen::Quaternionf> values, float tolerance);

}  // namespace knuckle
