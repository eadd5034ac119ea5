#pragma once

#include <vector>

#include "sim/rig/figure.h"
#include "sim/rig/mesh/triangle_tree.h"

namespace knuckle {

/// Which limb a point of the skin belongs to.
class LimbOwner {
public:
    /// Refers to the figure, whose model has a skin.
    explicit LimbOwner(const Figure& figure) : figure_(figure), sums_(figure.anatomy.size()) {}
    /// The bone that weighs most there, with all that is part of its body; of equal ones the first.
    uint32_t at(const SurfacePoint& point);
    uint32_t atMiddleOf(uint32_t triangle);

private:
    const Figure& figure_;
    std::vector<float> sums_;
};

}  // namespace knuckle
