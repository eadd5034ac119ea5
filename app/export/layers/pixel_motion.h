#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "render/layers/layers.h"
#include "sim/solver/measure/view_state.h"
#include "sim/world/world.h"

namespace knuckle {

/// Pixels' places; those of Layers.
Eigen::Vector3d worldPlace(const Layers& layers, uint32_t column, uint32_t row);
/// Where a place of the world is in a picture: column and row [pixels] from its upper left corner, and depth [m].
Eigen::Vector3d pictureOf(const Layers& layers, const LayerCamera& camera, const Eigen::Vector3d& place);

/// A moment and where it was seen from.
struct SeenState {
    ViewState view;
    LayerCamera camera;
};

/// How far each pixel's place has come in the picture since the frame before: to the right, and down [pixels].
/// @param before null: there is none, and nothing has moved.
std::vector<Eigen::Vector2f> pixelMotions(const World& world, const Layers& layers, const ViewState& now,
                                          const SeenState* before);

}  // namespace knuckle
