#pragma once

#include <span>

#include "sim/rig/anatomy/anatomy.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Turns a skeleton whose file does not say which axis points up so that its head is over its feet, where that is
/// another axis than y: at rest and in clips alike. A figure that lies in its clips, and stands at rest, lies. Told in
/// a note. @param anatomy of its bones, one each. @returns whether it was turned.
bool standUpright(Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
