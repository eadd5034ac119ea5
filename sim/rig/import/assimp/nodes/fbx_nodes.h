#pragma once

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

// What assimp makes of FBX's nodes. A node of FBX places itself by
//   T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, and what hangs on it alone by G besides
// (FBX SDK, "Computing transformation matrices"); of those parts that are not 1 assimp makes a row of nodes, "Hips"
// after "Hips_$AssimpFbx$_PreRotation" and so on.
namespace knuckle {

/// Whether assimp made a node of that name for a part of an FBX node's transform.
bool isPivot(const std::string& name);

/// FBX's "InheritType": in which order a node takes in the scale of what it hangs on, after the rotations.
enum class FbxInherit {
    AfterRotation,  ///< 0, RrSs: R r S s.
    AsMatrices,     ///< 1, RSrs: R S r s, as in most formats.
    NotTheParents   ///< 2, Rrs: without the scale that the parent itself has.
};

/// An FBX node and the row of nodes that assimp made of it.
struct FbxNode {
    std::vector<uint32_t> parts;  ///< In order, the last of its own name; without those of G.
    int32_t parent = -1;          ///< The FbxNode that it hangs on, -1: none.
    FbxInherit inherit = FbxInherit::AsMatrices;
};

/// The nodes of a scene as lists, parents first, by which FBX's are found and placed.
struct FbxNodes {
    FbxNodes() = default;
    /// @param parents per node its parent, or -1.
    FbxNodes(const std::vector<const aiNode*>& nodes, const std::vector<int32_t>& parents);

    /// Whether every node is placed by its parent's matrix times its own: always so outside FBX.
    bool areChains() const { return list.empty(); }
    /// Nodes to the world. @param locals per node: to its parent.
    std::vector<Eigen::Matrix4d> place(const std::vector<Eigen::Matrix4d>& locals,
                                       const std::vector<int32_t>& parents) const;

    std::vector<FbxNode> list;    ///< Empty where no node inherits its parent's scale in FBX's other ways.
    std::vector<int32_t> nodeOf;  ///< Per node: of which FbxNode it is the first part, or -1.
};

/// Where a skinned mesh stands in its node: G of the FBX node, which its bind matrices do not hold. 1 elsewhere.
Eigen::Matrix4d geometricOffset(const aiNode& node);

/// What a channel of a clip says of an FBX node. Where assimp joins the parts of T, Rpre, R, Rpost and S to one channel
/// for the last node of the row, the nodes before it are still there; and it forgets to invert Rpost.
struct FbxChannel {
    std::vector<const aiNode*> contained;  ///< Nodes that the channel stands for as well.
    /// By which rotations of the channel are to be multiplied on the right.
    Eigen::Matrix3d correction = Eigen::Matrix3d::Identity();
};
FbxChannel fbxChannel(const aiNode& node);

/// Where a clip has no curve for an axis of a part T, R or S that stands in a row, assimp takes 0 (1 of scale) instead
/// of what the node says. @returns the axes of whose keys that may be said, as "Lcl Translation of Hips along y"; empty
/// where there are none.
std::string axisWithoutKeys(const aiNode& node, const aiNodeAnim& channel);

}  // namespace knuckle
