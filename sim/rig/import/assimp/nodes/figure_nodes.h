#pragma once

#include <assimp/scene.h>

#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Of a scene of rigid parts that no clip moves: the nodes that names call parts of a body and that meshes hang on, and
/// one that leads to all where some parts hang on none. None where they are no figure.
std::vector<uint32_t> figureNodes(const NodeTable& table);

}  // namespace knuckle
