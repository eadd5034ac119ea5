#pragma once

#include <span>
#include <vector>

#include "sim/rig/figure.h"

namespace knuckle {

/// How thick a bone's part of the mesh is across the bone, at its middle.
struct LimbThickness {
    uint32_t bone = 0;
    float thickness = 0.0f;  ///< Twice the mean distance of the surface from its middle [m].
    float length = 0.0f;     ///< From the bone's head to its child's [m].
};

/// Of all forearms, shins, upper arms and thighs, or if none is known of all bones with a child that are longer than
/// thick and larger than a finger; in the order of bones.
std::vector<LimbThickness> limbThicknesses(const Figure& figure);

/// The particle diameter that puts two and a half particles across the thinnest of the limbs [m]; 0 for none.
float limbDiameter(std::span<const LimbThickness> limbs);

}  // namespace knuckle
