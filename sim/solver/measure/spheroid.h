#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace knuckle {

/// The form of a particle that others of its fluid hide from all sides: a ball.
constexpr uint32_t INNER = 1;

/// The form of a fluid particle, see shaders/math/spheroid.glsl.
struct Spheroid {
    Eigen::Vector3d axis{0, 1, 0};     ///< Unit.
    double along = 1.0, across = 1.0;  ///< Half lengths along the axis and across it, over a radius.
};

Spheroid unpackSpheroid(uint32_t word);

}  // namespace knuckle
