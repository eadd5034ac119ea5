#pragma once

#include <assimp/scene.h>

#include <string>
#include <vector>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

/// Fills NodeTable::boneNodes. @throws InputError for a bone without a node.
void findBoneNodes(const aiScene& scene, NodeTable& table);

/// The nodes that bones of meshes name, ascending. Without meshes, the whole skeleton except nodes that only hold it,
/// cameras and lights. If no mesh has bones, movedNodes() or figureNodes().
std::vector<uint32_t> bonesIn(const aiScene& scene, const NodeTable& table);

/// A bone's matrix to the model, from the node's. Mirrored nodes would not turn bodies, so their third axis is
/// reversed, at rest and in clips alike.
Eigen::Matrix4f bonePose(const Eigen::Matrix4d& global);

/// Names of nodes as bones: those of the file, numbered if several are the same.
std::vector<std::string> boneNames(const NodeTable& table, const std::vector<uint32_t>& nodes);

/// Fills Model::bones from nodes, parents first.
void convertBones(const std::vector<uint32_t>& nodes, NodeTable& table, Model& model);

}  // namespace knuckle
