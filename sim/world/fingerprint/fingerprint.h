#pragma once

#include <cstdint>

#include "sim/world/world.h"

namespace knuckle {

/// A number by which the state of a run can say of which World it is: of two Worlds with the same one a run takes the
/// same bits. FNV-1a over every field that a run depends on, in the order of the structs, so that equal Worlds have the
/// same one on every machine.
///
/// Left out is what is only told or drawn: names, colours, `Collider::visible`, skins, the triangles of a mesh. A run
/// may go on after such a change, in other colours.
uint64_t fingerprint(const World& world);

}  // namespace knuckle
