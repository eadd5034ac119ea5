#pragma once

#include <span>
#include <vector>

#include "app/scene/scene_context.h"

namespace knuckle {

/// Fills the region of an object (its `shape`: box, sphere, capsule, cone or mesh, with the fields of that shape) with
/// points of a cubic lattice.
/// @param spacing of the lattice, and the size of particles on it [m].
/// @returns at least one point, in the object's own frame. @throws InputError if none fits, or too many do.
std::vector<Vector3f> fillRegion(const SceneEntry& object, float spacing);

/// Index of the point nearest to a place; of several the first. @param points at least one.
uint32_t nearestPoint(std::span<const Vector3f> points, const Vector3f& place);

/// Indices of the points nearest to an entry's `pins`. @param points of the object, in its own frame [m]; at least one.
/// @throws InputError for a pin that is further than a diameter from all of them.
std::vector<uint32_t> pinnedPoints(const SceneEntry& entry, std::span<const Vector3f> points);

/// Moves each point by up to `amount` [m] along each axis; the same seed moves them the same way everywhere.
void jitterPositions(std::vector<Vector3f>& positions, float amount, uint32_t seed);

}  // namespace knuckle
