#pragma once

#include <array>
#include <vector>

#include "tools/shapes/figure.h"
#include "tools/shapes/skeleton.h"

namespace knuckle {

/// A leg of the left side: names and places of its bones. The whole leg lies in the upright plane through the hip along
/// `out`.
struct SpiderLeg {
    std::array<const char*, 3> bones;  ///< Coxa, femur, tibia.
    Eigen::Vector3d hip;               ///< [m]
    Eigen::Vector3d out;               ///< Unit, horizontal.
    double phase;                      ///< Of the left one; the right one is half a stride later.
};
extern const std::array<SpiderLeg, 3> SPIDER_LEGS;

/// From the hip along `out` and up [m].
inline const Eigen::Vector2d FEMUR{0.095, 0.0}, TIBIA{0.245, 0.150}, FOOT{0.400, -0.298};
inline constexpr double FOOT_RADIUS = 0.022;  ///< [m]

/// @param place as those above.
Eigen::Vector3d inLeg(const SpiderLeg& leg, const Eigen::Vector2d& place);

/// The shells of all bones.
std::vector<Figure> spiderFigures(const Skeleton& skeleton);

Clip spiderWalk(const Skeleton& skeleton);

}  // namespace knuckle
