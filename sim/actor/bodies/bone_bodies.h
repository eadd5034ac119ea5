#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/actor/anatomy/anatomy.h"
#include "sim/actor/import/model.h"
#include "sim/actor/limbs/mirror.h"

namespace knuckle {

/// A body before its joints are made: a bone, and the particles that it and the bones merged into it took.
struct BodyDraft {
    std::string name;
    uint32_t bone = NO_INDEX;
    int32_t parent = -1;              ///< Into the list of drafts; parents come first.
    std::vector<uint32_t> particles;  ///< Into Voxels, ascending.
    std::vector<uint32_t> mergedBones;
    Eigen::Vector3f anchor{0, 0, 0};  ///< Where its joint with the parent sits [m].
};

/// Cuts the particles into one body per limb that is large enough, arranged as a tree with one root. `notes` gets a
/// sentence for whatever was joined elsewhere than the skeleton says.
/// @param anatomy of the model's bones, one each.
/// @param mirror null for a model without symmetry; else both sides are cut alike, and may get or lose particles.
/// @param forward where the figure looks, level and unit.
std::vector<BodyDraft> cutIntoBodies(const Model& model, const Solid& solid, std::span<const BoneAnatomy> anatomy,
                                     const Mirror* mirror, const Eigen::Vector3f& forward, Voxels& voxels,
                                     std::vector<std::string>& notes);

/// Four or more points that do not lie in one plane, give or take a tenth of a diameter.
bool spansSpace(const std::vector<Eigen::Vector3f>& points, float diameter);

/// The bone's head in the rest pose [m].
Eigen::Vector3f boneHead(const Model& model, uint32_t bone);

}  // namespace knuckle
