#pragma once

#include <cstdint>
#include <vector>

#include "app/json/json.h"
#include "sim/world/world.h"

namespace knuckle {

/// Places of an object's copies. Deterministic: the same seed gives the same places everywhere.
std::vector<Pose> repeatedPoses(const Json& object);
/// The delay of a copy's motion and release after the first copy's [s].
float delayOf(const Json& object, size_t copy);
/// Delays plays; until it begins, a clip that does not loop is held at its start.
std::vector<ClipPlay> delayed(const World& world, std::vector<ClipPlay> plays, float delay);
/// Product of repeat.counts, exact up to 1e18.
uint64_t copyCount(const Json& object);

}  // namespace knuckle
