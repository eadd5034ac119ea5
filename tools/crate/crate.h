#pragma once

#include "sim/rig/model.h"

namespace knuckle {

/// A wooden crate of 0.27 m about the origin: planks within a frame, braces across its four upright sides. One bone,
/// and closed shells that overlap.
Model makeCrate();

}  // namespace knuckle
