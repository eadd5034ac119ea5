#pragma once

#include <span>
#include <utility>
#include <vector>

#include "sim/rig/actor.h"
#include "sim/rig/import/import.h"

namespace knuckle {

/// The weights of a vertex summed by owners of its bones, heaviest first. @param owners per bone.
std::vector<std::pair<uint32_t, float>> weightsByOwner(const SkinWeights& skin, std::span<const uint32_t> owners);

/// The four heaviest of them. @param order heaviest first.
BodyWeights heaviestOf(std::vector<std::pair<uint32_t, float>> order);

/// Per bone of a model, the body of its actor that moves it: the one that it became or was merged into, else that of
/// the nearest bone above that has one, else the first.
/// @throws InputError if the actor has several bodies and none of them is a bone of the model.
std::vector<uint32_t> bodiesOfBones(const Actor& actor, const Model& model);

/// The mesh of an actor's own model, skinned to its bodies: each vertex to the four with the largest weights.
/// @param model read with ImportOptions::surface, at the scale that the actor was made with.
/// @throws InputError for a model that has no mesh to draw, or is not the actor's.
SkinMesh makeSkinMesh(const Actor& actor, const Model& model);

}  // namespace knuckle
