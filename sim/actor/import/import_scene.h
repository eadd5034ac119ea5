#pragma once

#include <assimp/scene.h>

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "sim/actor/import/model.h"

// Inside the importing child only: the files import_*.cpp alone know assimp.
namespace knuckle {

/// The node tree of a scene as lists, parents first.
struct NodeTable {
    std::vector<const aiNode*> nodes;
    std::vector<int32_t> parents;
    std::vector<Eigen::Matrix4d> locals, globals;  ///< At rest.
    std::map<const aiNode*, uint32_t> indices;
    std::vector<int32_t> boneOf;                            ///< Index of the node's bone in Model::bones, or -1.
    Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();  ///< Turns the file's up axis to +y; part of globals.

    /// The bone of the node or of the nearest ancestor that has one, or -1.
    int32_t boneAbove(uint32_t node) const;
};

/// @throws InputError for a tree that is too deep or large, or a transform that is not finite.
NodeTable listNodes(const aiScene& scene);

/// The node that moves with the bone. @throws InputError if the scene has none.
const aiNode& nodeOfBone(const aiScene& scene, const aiBone& bone);

/// Fills Model::bones from the nodes that bones of meshes name (all nodes if there are no meshes), parents first.
void convertBones(const aiScene& scene, NodeTable& table, Model& model);

/// Adds all triangles, skinned into the rest pose of the nodes, with normalized weights. @throws InputError for
/// vertices that are not finite, indices out of range, counts over the limit, singular bind matrices.
void convertMeshes(const aiScene& scene, const NodeTable& table, Model& model);

/// Samples every animation into bone-to-model matrices at a fixed rate.
void convertClips(const aiScene& scene, const NodeTable& table, Model& model);

Eigen::Matrix4d toEigen(const aiMatrix4x4& m);

/// Calls visit(mesh, node) for each mesh that a node shows, in the order in which Model::vertices has them. A skinned
/// one is shown once: it stands where its bones are, whichever node names it.
void forEachMesh(const aiScene& scene, const NodeTable& table,
                 const std::function<void(const aiMesh&, uint32_t)>& visit);

/// Per bone of a mesh: from the mesh's space to the model's in the rest pose of the nodes.
/// @throws InputError for a bind matrix that is singular or not a number.
std::vector<Eigen::Matrix4d> skinMatrices(const aiMesh& mesh, const NodeTable& table, const aiScene& scene);

/// Fills Model::surface for the vertices that convertMeshes() added. What of a texture cannot be had is a note.
/// @param path of the model's file.
void convertSurface(const aiScene& scene, const NodeTable& table, const std::string& path, Model& model);

/// Fills the materials that the scene's meshes have, and reads their textures. @returns per material of the scene its
/// index among them, NO_INDEX where no mesh has it.
std::vector<uint32_t> convertMaterials(const aiScene& scene, const std::string& path, Model& model);

/// Reads and converts a file, in the file's own units. @param surface see ImportOptions. @throws InputError.
Model readScene(const std::string& path, bool surface);

}  // namespace knuckle
