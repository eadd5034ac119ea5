#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace knuckle {

/// Points of a frame as VTK PolyData; all lists have a value, or three, for each point.
struct VtpPoints {
    std::vector<float> places, velocities;
    std::vector<uint32_t> ids;
    std::vector<int32_t> bodies, materials;
    std::vector<float> radii;
    std::vector<float> densities;  ///< Empty: not known.
};

/// What the numbers stand for, by index.
struct VtpNames {
    std::vector<std::string> bodies, materials;
};

/// The file of a frame. @param time [s]
std::string vtpText(const VtpPoints& points, const VtpNames& names, double time);

}  // namespace knuckle
