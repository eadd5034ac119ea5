#include "sim/rig/figure.h"

#include <utility>

namespace knuckle {

using Eigen::Vector3f;

Figure readFigure(const Model& model, std::map<uint32_t, BoneRole> wanted)
{
    Figure figure{model, BoneTree(model), std::move(wanted), {}, {}};
    if (model.isSplit) {
        figure.anatomy.resize(model.bones.size());
        return figure;
    }
    figure.anatomy = readAnatomy(model, figure.wanted);
    figure.mirror = findMirror(figure.tree);
    if (figure.mirror) figure.mirror->keepAlike(figure.anatomy);
    figure.left = leftOf(model, figure.anatomy);
    figure.forward = figure.left.cross(Vector3f::UnitY());
    figure.upright = isUpright(model, figure.anatomy);
    return figure;
}

std::optional<Vector3f> limbEnd(const Figure& figure, uint32_t limb)
{
    const Model& model = figure.model;
    std::optional<Vector3f> end;
    float farthest = 0.0f;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const float length = (boneHead(model, b) - boneHead(model, limb)).norm();
        if (figure.anatomy[b].parent != static_cast<int32_t>(limb) || length <= farthest) continue;
        farthest = length;
        end = boneHead(model, b);
    }
    return end;
}

}  // namespace knuckle
