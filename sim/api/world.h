#pragma once

/// Worlds as plain data, and their construction: `WorldBuilder` takes materials, colliders, bodies and their joints,
/// addRope() and addCloth() what hangs on them, WorldBuilder::build() gives the World. SI units, +Y up, radians.
///
/// Errors are exceptions (errors.h): InputError for a World that cannot be simulated as it is, std::logic_error for a
/// call against its contract.

#include "sim/base/errors.h"
#include "sim/world/builder/builder.h"
#include "sim/world/builder/parts/cloth.h"
#include "sim/world/builder/parts/rope.h"
#include "sim/world/world.h"
