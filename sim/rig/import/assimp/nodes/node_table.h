#pragma once

#include <assimp/scene.h>

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/rig/import/assimp/nodes/fbx_nodes.h"
#include "sim/rig/model.h"

namespace knuckle {

/// Bones of one mesh from which on it is a figure.
constexpr size_t FEWEST_SKINNED = 3;

/// The node tree of a scene as lists, parents first.
struct NodeTable {
    std::vector<const aiNode*> nodes;
    std::vector<int32_t> parents;
    std::vector<Eigen::Matrix4d> locals, globals;  ///< At rest.
    FbxNodes fbx;                                  ///< How node-to-world matrices follow from node-to-parent ones.
    std::map<const aiNode*, uint32_t> indices;
    std::vector<int32_t> boneOf;                            ///< Index of the node's bone in Model::bones, or -1.
    Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();  ///< Turns the file's up axis to +y; part of globals.
    std::map<const aiBone*, uint32_t> boneNodes;            ///< The node that moves with each bone of a mesh.
    std::map<std::string, std::string> originals;           ///< FileNames::originals.
    bool isBare = false;                                    ///< Whether the scene has no mesh but a skeleton.
    bool isPicked = false;                                  ///< Whether only meshes that hang on bones of the model are
                                                            ///< part of it.

    bool isOfParts = false;                              ///< Whether nodes with meshes may be bones.
    std::set<std::pair<const aiMesh*, uint32_t>> apart;  ///< By node: meshes that are not part of the figure.

    /// The bone of the node or of the nearest ancestor that has one, or -1.
    int32_t boneAbove(uint32_t node) const;
    /// The number of nodes above both, including themselves.
    size_t sharedDepth(uint32_t a, uint32_t b) const;
    /// The lowest node above both.
    uint32_t commonNode(uint32_t a, uint32_t b) const;
    /// The file's name for a node.
    std::string nameOf(uint32_t node) const;
    /// Whether a mesh that is skinned to bones, or hangs on the node, is part of the model.
    bool takes(const aiMesh& mesh, uint32_t node) const;
};

/// @throws InputError for a tree that is too deep or large, or a transform that is not finite.
NodeTable listNodes(const aiScene& scene);

/// Whether a bone moves any vertex.
bool moves(const aiBone& bone);

/// Whether a name was given by a person, not made up by an importer.
bool isGivenName(std::string_view name);

Eigen::Matrix4d toEigen(const aiMatrix4x4& m);

}  // namespace knuckle
