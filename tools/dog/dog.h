#pragma once

#include "sim/rig/model.h"

namespace knuckle {

/// A dog generated entirely by this code: 0.6 m high at the withers, standing on y = 0 and facing +z, with pricked ears
/// and a bushy tail; 26 bones, and two clips that continue from where they end: "walk" and "trot".
Model makeDog();

}  // namespace knuckle
