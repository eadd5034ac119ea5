#pragma once

#include <vector>

#include "sim/rig/model.h"

namespace knuckle {

/// Of one clip, key by key.
using Turns = std::vector<Eigen::Quaternionf>;

/// How a bone turns against another in each clip, from the rest pose, in the model's directions.
std::vector<Turns> clipTurns(const Model& model, uint32_t bone, uint32_t parent);

/// The same turns seen in a mirror. @param across the mirror's normal, unit.
Turns mirrored(Turns turns, const Eigen::Vector3f& across);

}  // namespace knuckle
