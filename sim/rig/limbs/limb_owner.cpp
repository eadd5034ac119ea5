#include "sim/rig/limbs/limb_owner.h"

#include <algorithm>

namespace knuckle {

uint32_t LimbOwner::at(const SurfacePoint& point)
{
    std::ranges::fill(sums_, 0.0f);
    const Model& model = figure_.model;
    for (int corner = 0; corner < 3; ++corner) {
        const SkinWeights& skin = model.skin[model.triangles[point.triangle][static_cast<size_t>(corner)]];
        for (size_t i = 0; i < skin.bones.size(); ++i)
            sums_[figure_.anatomy[skin.bones[i]].owner] += point.barycentric[corner] * skin.weights[i];
    }
    return static_cast<uint32_t>(std::ranges::max_element(sums_) - sums_.begin());
}

uint32_t LimbOwner::atMiddleOf(uint32_t triangle)
{
    SurfacePoint middle;
    middle.triangle = triangle;
    middle.barycentric = Eigen::Vector3f::Constant(1.0f / 3.0f);
    return at(middle);
}

}  // namespace knuckle
