#pragma once

#include <span>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// If a file does not say which axis points up, and a skeleton's head is over its feet along another axis than y, turns
/// it so that this is y: at rest and in clips alike. A figure that lies in its clips but stands at rest stays lying.
/// Adds a note. @param anatomy of its bones, one each. @returns whether it was turned.
bool standUpright(Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
