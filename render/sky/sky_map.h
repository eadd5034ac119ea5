#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace knuckle {

/// Light from everywhere around: rows from straight up to straight down, columns once around. A column u of 0 ... 1
/// looks towards (-sin, ., cos) of 2 pi u, so that the middle of a picture is at -z.
struct SkyMap {
    uint32_t width = 0, height = 0;         ///< [texels]
    std::vector<Eigen::Vector3f> radiance;  ///< Linear RGB, >= 0, width * height.

    /// Unit, of the middle of a texel.
    Eigen::Vector3f direction(uint32_t column, uint32_t row) const;
    const Eigen::Vector3f& at(uint32_t column, uint32_t row) const { return radiance[size_t{row} * width + column]; }
    /// Share of the sphere that a texel of a row covers, times 4 pi.
    float solidAngle(uint32_t row) const;
    /// What arrives at a level surface that looks up (or down), over pi: the mean radiance weighted by cosines.
    Eigen::Vector3f meanOf(bool up) const;
};

/// The map at half its sides, at least one texel: means by solid angle.
SkyMap halved(const SkyMap& map);
/// What surfaces of a roughness mirror of it, where they are seen straight on: means over the lobe of Trowbridge and
/// Reitz (B. Karis, "Real Shading in Unreal Engine 4", 2013), in a map of that width.
SkyMap blurred(const SkyMap& map, float roughness, uint32_t width);

}  // namespace knuckle
