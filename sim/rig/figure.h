#pragma once

#include <map>
#include <optional>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/anatomy/bone_tree.h"
#include "sim/rig/anatomy/shape/mirror.h"
#include "sim/rig/model.h"

namespace knuckle {

/// What bodies, joints and clips are made from: a model with all data read from its skeleton, once.
struct Figure {
    const Model& model;
    BoneTree tree;
    std::map<uint32_t, BoneRole> wanted;  ///< Roles that options give, by bone.
    std::vector<BoneAnatomy> anatomy;     ///< One a bone; without meaning for separate parts.
    std::optional<Mirror> mirror;         ///< None for a skeleton without symmetry.
    Eigen::Vector3f left{1, 0, 0};        ///< Level and unit, as `forward`.
    Eigen::Vector3f forward{0, 0, 1};     ///< The direction that it faces in its rest pose.
    bool upright = true;                  ///< See isUpright().

    /// Whether bodies can be cut along bones: it has some, and a skin for them.
    bool hasSkin() const { return !model.bones.empty() && model.skin.size() == model.vertices.size(); }
};

/// @param model has to outlive the figure. @param wanted roles of bones, by index, which override names.
Figure readFigure(const Model& model, std::map<uint32_t, BoneRole> wanted = {});
Figure readFigure(Model&&, std::map<uint32_t, BoneRole> = {}) = delete;

/// Among the limbs that hang on this one, the head farthest from its own [m]; nothing if there are none.
std::optional<Eigen::Vector3f> limbEnd(const Figure& figure, uint32_t limb);

}  // namespace knuckle
