#pragma once

#include <assimp/scene.h>

#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// In a scene of rigid parts: the nodes with meshes that clips move, and one above all if some parts stand still. Empty
/// if no clip moves any part.
std::vector<uint32_t> movedNodes(const aiScene& scene, const NodeTable& table);

}  // namespace knuckle
