#pragma once

#include <assimp/scene.h>

#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// In a scene of rigid parts that no clip moves: the nodes with meshes that are named after parts of a body, and one
/// above all if some parts hang on none. Empty if they form no figure.
std::vector<uint32_t> figureNodes(const NodeTable& table);

}  // namespace knuckle
