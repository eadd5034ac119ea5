#include "sim/solver/measure/spheroid.h"

#include <algorithm>
#include <cmath>

namespace knuckle {

Spheroid unpackSpheroid(uint32_t word)
{
    if (word <= INNER) return {};
    const double x = (word & 511) / 255.5 - 1.0, y = (word >> 9 & 511) / 255.5 - 1.0;
    Eigen::Vector3d axis(x, y, 1.0 - std::abs(x) - std::abs(y));
    const double fold = std::max(-axis.z(), 0.0);
    axis.x() -= std::copysign(fold, x);
    axis.y() -= std::copysign(fold, y);
    const auto length = [](uint32_t steps) { return std::exp2(0.9 * (steps - 64.0) / 63.0); };
    return {axis.normalized(), length(word >> 18 & 127), length(word >> 25)};
}

}  // namespace knuckle
