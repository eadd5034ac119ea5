#pragma once

#include <assimp/scene.h>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Samples every animation into bone-to-model matrices at a fixed rate.
void convertClips(const aiScene& scene, const NodeTable& table, Model& model);

}  // namespace knuckle
