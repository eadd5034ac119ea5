#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle {

/// Signs that a figure faces the way that the sides of its limbs say, and signs of the opposite.
struct Facing {
    std::vector<std::string> agree, disagree;  ///< "toes", "face", "knees", ...
    float balance = 0.0f;                      ///< The weights of what agrees minus those of what disagrees.
    float against = 0.0f;                      ///< The weights of what disagrees.
};

/// Counts the signs of a figure with limbs on both sides: toes before ankles, face bones before the head, knees before
/// and elbows behind straight limbs, thumbs before the other fingers, tails behind, a creature's head before its hips,
/// and in clips bent knees and steps.
Facing readFacing(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Whether signs tell which way the figure faces, regardless of names.
bool isFacingKnown(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Swaps the sides of figures whose names say left for right, as seen by a viewer who faces the figure. Sides without
/// names need weaker signs.
void settleSides(const Model& model, std::vector<BoneAnatomy>& anatomy);

/// A note about which signs won over which; empty if hardly any disagrees.
std::string facingNote(const Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
