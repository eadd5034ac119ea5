#pragma once

#include <assimp/scene.h>

#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Of a scene of rigid parts: the nodes that clips move and that meshes hang on, and one that leads to all where some
/// parts stand still. None if no clip moves any part.
std::vector<uint32_t> movedNodes(const aiScene& scene, const NodeTable& table);

}  // namespace knuckle
