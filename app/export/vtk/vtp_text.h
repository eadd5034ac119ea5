#pragma once

#include <string>
#include <vector>

#include "app/export/points/particle_points.h"

namespace knuckle {

/// What the numbers stand for, by index.
struct VtpNames {
    std::vector<std::string> bodies, materials;
};

/// The file of a frame. @param time [s]
std::string vtpText(const ParticlePoints& points, const VtpNames& names, double time);

}  // namespace knuckle
