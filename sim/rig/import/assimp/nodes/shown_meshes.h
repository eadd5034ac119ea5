#pragma once

#include <assimp/scene.h>

#include <functional>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Calls visit(mesh, node) for each mesh that a node shows, in the order in which Model::vertices has them. A skinned
/// mesh is shown once: it is where its bones are, whichever node names it.
void forEachMesh(const aiScene& scene, const NodeTable& table,
                 const std::function<void(const aiMesh&, uint32_t)>& visit);

/// Per bone of a mesh: from the mesh's space to the model's in the rest pose of the nodes. @param node shows the mesh.
/// @throws InputError for a bind matrix that is singular or not a number.
std::vector<Eigen::Matrix4d> skinMatrices(const aiMesh& mesh, uint32_t node, const NodeTable& table);

}  // namespace knuckle
