#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace knuckle {

/// A number that identifies the World of a run's state: two Worlds with the same number give the same bits. FNV-1a over
/// every field that a run depends on, in the order of the structs, so that equal Worlds have the same number on every
/// machine.
///
/// Leaves out fields that are only printed or drawn: names, colours, `Collider::visible`, `World::unseen`, skins,
/// shapes, the triangles of a mesh. A run may go on after such a change, in other colours.
uint64_t fingerprint(const World& world);

}  // namespace knuckle
