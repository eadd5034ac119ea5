#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace knuckle {

/// The form of a fluid particle, see shaders/math/spheroid.glsl.
struct Spheroid {
    Eigen::Vector3d axis{0, 1, 0};     ///< Unit.
    double along = 1.0, across = 1.0;  ///< Half lengths along the axis and across it, over a radius.
};

Spheroid unpackSpheroid(uint32_t word);

}  // namespace knuckle
