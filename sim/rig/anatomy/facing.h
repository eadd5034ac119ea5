#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/rig/anatomy/anatomy.h"

namespace knuckle {

/// What says that a figure looks where the sides of its limbs have it look, and what says the opposite.
struct Facing {
    std::vector<std::string> agree, disagree;  ///< "toes", "face", "knees", ...
    float balance = 0.0f;                      ///< Of what agrees over what does not, each by how much it says.
    float against = 0.0f;                      ///< The same of what does not agree.
};

/// Counts the signs of a figure with limbs on both sides: toes before ankles, face bones before the head, knees before
/// and elbows behind straight limbs, thumbs before the other fingers, tails behind, a creature's head before its hips,
/// and in clips bent knees and steps.
Facing readFacing(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Whether signs tell it, whatever names say.
bool isFacingKnown(const Model& model, std::span<const BoneAnatomy> anatomy);

/// Turns round the sides of figures whose names call left what is right, as one sees them who faces it. Sides that
/// nobody names are turned by less.
void settleSides(const Model& model, std::vector<BoneAnatomy>& anatomy);

/// A note of which signs won over which; empty where hardly any disagrees.
std::string facingNote(const Model& model, std::span<const BoneAnatomy> anatomy);

}  // namespace knuckle
