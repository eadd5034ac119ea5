#pragma once

#include <assimp/scene.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/actor/import/fbx/fbx_nodes.h"
#include "sim/actor/import/import.h"
#include "sim/actor/model_source.h"

namespace Assimp {
class Importer;
}

// Inside the importing child only: the files import_*.cpp alone know assimp.
namespace knuckle {

/// Bones of one mesh that make it a figure's.
constexpr size_t FEWEST_SKINNED = 3;

/// The node tree of a scene as lists, parents first.
struct NodeTable {
    std::vector<const aiNode*> nodes;
    std::vector<int32_t> parents;
    std::vector<Eigen::Matrix4d> locals, globals;  ///< At rest.
    FbxNodes fbx;                                  ///< How nodes to the world come of those to their parents.
    std::map<const aiNode*, uint32_t> indices;
    std::vector<int32_t> boneOf;                            ///< Index of the node's bone in Model::bones, or -1.
    Eigen::Matrix4d upright = Eigen::Matrix4d::Identity();  ///< Turns the file's up axis to +y; part of globals.
    std::map<const aiBone*, uint32_t> boneNodes;            ///< The node that moves with each bone of a mesh.
    std::map<std::string, std::string> originals;           ///< FileNames::originals.
    bool isBare = false;                                    ///< Whether the scene has no mesh but a skeleton.
    bool isPicked = false;                                  ///< Whether only what hangs on bones of the model is taken.

    bool isOfParts = false;                              ///< Whether nodes that meshes hang on may be bones.
    std::set<std::pair<const aiMesh*, uint32_t>> apart;  ///< By node: meshes that are no part of the figure.

    /// The bone of the node or of the nearest ancestor that has one, or -1.
    int32_t boneAbove(uint32_t node) const;
    /// How many nodes lead to both, themselves among them.
    size_t sharedDepth(uint32_t a, uint32_t b) const;
    /// The lowest node that leads to both.
    uint32_t commonNode(uint32_t a, uint32_t b) const;
    /// What the file calls a node.
    std::string nameOf(uint32_t node) const;
    /// Whether a mesh that is skinned to bones, or hangs on the node, is part of the model.
    bool takes(const aiMesh& mesh, uint32_t node) const;
};

/// @throws InputError for a tree that is too deep or large, or a transform that is not finite.
NodeTable listNodes(const aiScene& scene);

/// Fills NodeTable::boneNodes. @throws InputError for a bone without a node.
void findBoneNodes(const aiScene& scene, NodeTable& table);

/// Where nodes stand in a frame of a clip, gives bones the pose in which meshes are bound to them (NodeTable::globals),
/// unless their bind matrices are none. Which is a note.
void takeBindPose(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

/// The nodes that bones of meshes name, ascending. If there are no meshes, all of the skeleton, without what only holds
/// it, cameras and lights. If no mesh has bones, movedNodes() or figureNodes().
std::vector<uint32_t> bonesIn(const aiScene& scene, const NodeTable& table);

/// Of a scene of rigid parts: the nodes that clips move and that meshes hang on, and one that leads to all where some
/// parts stand still. None if no clip moves any part.
std::vector<uint32_t> movedNodes(const aiScene& scene, const NodeTable& table);

/// Of a scene of rigid parts that no clip moves: the nodes that names call parts of a body and that meshes hang on, and
/// one that leads to all where some parts hang on none. None where they are no figure.
std::vector<uint32_t> figureNodes(const NodeTable& table);

/// Whether a name is one that somebody gave, not one that importers make up.
bool isGivenName(std::string_view name);

/// Fills NodeTable::apart: where meshes are skinned to a figure, those that hang on no bone and are not within its
/// bounds, as floors are.
void leaveApart(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes);

/// A bone to the model, of the node's matrix. Mirrored nodes would not turn bodies: of such the third axis points the
/// other way, at rest and in clips alike.
Eigen::Matrix4f bonePose(const Eigen::Matrix4d& global);

/// Names of nodes as bones: those of the file, numbered where several have the same.
std::vector<std::string> boneNames(const NodeTable& table, const std::vector<uint32_t>& nodes);

/// The nodes that become bones: of a file with several skeletons those of the one that is picked.
/// Several skeletons are what has a mesh each, skinned to three of its bones or more, where no mesh is skinned to
/// bones of two; in an export of a run what else stands beside a single figure is left out, too.
/// @throws SkeletonError where that is not said, or where there is none of the name.
std::vector<uint32_t> pickSkeleton(const aiScene& scene, const ModelPick& pick, NodeTable& table,
                                   std::vector<std::string>& notes);

/// Fills Model::bones from nodes, parents first.
void convertBones(const std::vector<uint32_t>& nodes, NodeTable& table, Model& model);

/// Adds all triangles, skinned into the rest pose of the nodes, with normalized weights. @throws InputError for
/// vertices that are not finite, indices out of range, counts over the limit, singular bind matrices.
void convertMeshes(const aiScene& scene, const NodeTable& table, Model& model);

/// Makes a bone of each separate part of the mesh: of what triangles and corners at the same place connect in one
/// node. It has the name of the node, the mesh or the material. @throws InputError for a model with a skeleton.
void splitIntoParts(const aiScene& scene, const NodeTable& table, Model& model);

/// Samples every animation into bone-to-model matrices at a fixed rate.
void convertClips(const aiScene& scene, const NodeTable& table, Model& model);

Eigen::Matrix4d toEigen(const aiMatrix4x4& m);

/// Calls visit(mesh, node) for each mesh that a node shows, in the order in which Model::vertices has them. A skinned
/// one is shown once: it stands where its bones are, whichever node names it.
void forEachMesh(const aiScene& scene, const NodeTable& table,
                 const std::function<void(const aiMesh&, uint32_t)>& visit);

/// Per bone of a mesh: from the mesh's space to the model's in the rest pose of the nodes. @param node shows the mesh.
/// @throws InputError for a bind matrix that is singular or not a number.
std::vector<Eigen::Matrix4d> skinMatrices(const aiMesh& mesh, uint32_t node, const NodeTable& table);

/// Fills Model::surface for the vertices that convertMeshes() added. What of a texture cannot be had is a note.
/// @param path of the model's file.
void convertSurface(const aiScene& scene, const NodeTable& table, const std::string& path, Model& model);

/// What became of a material of the scene.
struct ConvertedMaterial {
    uint32_t index = NO_INDEX;  ///< In ModelSurface::materials; NO_INDEX where no mesh has it.
    unsigned uvChannel = 0;     ///< Of the places in its picture.
    Eigen::Affine2f moved = Eigen::Affine2f::Identity();  ///< Where it has them, v downwards.
};

/// Fills the materials that the scene's meshes have which are taken, and reads their textures. @returns per material of
/// the scene.
std::vector<ConvertedMaterial> convertMaterials(const aiScene& scene, const NodeTable& table, const std::string& path,
                                                Model& model);

/// What is to be known of a file that was changed for assimp.
struct FileNames {
    std::map<std::string, std::string> originals;  ///< Names of the file, by those that stand for them.
    std::vector<std::string> notes, missing;       ///< For the model; for its surface.
};

/// Reads a file with assimp. @throws SkeletonError as pickSkeleton().
const aiScene* readFile(Assimp::Importer& importer, const std::string& path, unsigned flags, const ModelPick& pick,
                        FileNames& names);

/// Reads and converts a file, in the file's own units. @param surface see ImportOptions. @throws InputError.
Model readScene(const std::string& path, bool surface, const ModelPick& pick);

}  // namespace knuckle
