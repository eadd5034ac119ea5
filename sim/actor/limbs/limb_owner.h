#pragma once

#include <span>
#include <vector>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/mesh/triangle_tree.h"

namespace knuckle {

/// Which limb a point of the skin belongs to.
class LimbOwner {
public:
    /// Refers to both. @param model with skin. @param anatomy of its bones, one each.
    LimbOwner(const Model& model, std::span<const BoneAnatomy> anatomy)
        : model_(model), anatomy_(anatomy), sums_(anatomy.size())
    {
    }
    /// The bone that weighs most there with all that is part of its body; of equal ones the first.
    uint32_t at(const SurfacePoint& point);
    uint32_t atMiddleOf(uint32_t triangle);

private:
    const Model& model_;
    std::span<const BoneAnatomy> anatomy_;
    std::vector<float> sums_;
};

}  // namespace knuckle
