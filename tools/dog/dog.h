#pragma once

#include "sim/rig/model.h"

namespace knuckle {

/// A dog made from nothing but this code: 0.6 m high at the withers, standing on y = 0 and facing +z, with pricked ears
/// and a bushy tail; 26 bones, and two clips that go on where they have come to: "walk" and "trot".
Model makeDog();

}  // namespace knuckle
