#pragma once

/// From a rigged model to a ragdoll: importModel() reads a file, makeActor() fills its mesh with particles and joins
/// its bodies, addActor() adds it to a WorldBuilder. Errors are InputError, one line each, as in world.h.

#include "sim/rig/actor.h"
#include "sim/rig/bodies/make_actor.h"
#include "sim/rig/import/import.h"
