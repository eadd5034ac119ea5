#pragma once

#include <vector>

#include "sim/actor/actor.h"
#include "sim/actor/import/model.h"

namespace knuckle {

/// Per bone of a model, the body of its actor that moves it: that which it became or was merged into, else that of the
/// nearest bone above that has one, else the first.
/// @throws InputError where the actor has several bodies and none of them is a bone of the model.
std::vector<uint32_t> bodiesOfBones(const Actor& actor, const Model& model);

/// The mesh of an actor's own model, skinned to its bodies: each vertex to the four that weigh most.
/// @param model read with ImportOptions::surface, at the scale that the actor was made with.
/// @throws InputError for a model that has no mesh to draw, or is another than the actor's.
SkinMesh makeSkinMesh(const Actor& actor, const Model& model);

}  // namespace knuckle
