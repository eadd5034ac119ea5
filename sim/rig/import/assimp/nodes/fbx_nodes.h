#pragma once

#include <assimp/anim.h>
#include <assimp/scene.h>

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <vector>

// How assimp represents FBX's nodes. A node of FBX places itself by
//   T Roff Rp Rpre R Rpost^-1 Rp^-1 Soff Sp S Sp^-1, and its attributes, but not its children, also by G
// (FBX SDK, "Computing transformation matrices"); assimp makes a row of nodes from those parts that are not 1: "Hips"
// after "Hips_$AssimpFbx$_PreRotation" and so on.
namespace knuckle {

/// Whether assimp made a node of that name for a part of an FBX node's transform.
bool isPivot(const std::string& name);

/// FBX's "InheritType": the order in which a node applies its parent's scale and rotations.
enum class FbxInherit {
    AfterRotation,  ///< 0, RrSs: R r S s.
    AsMatrices,     ///< 1, RSrs: R S r s, as in most formats.
    NotTheParents   ///< 2, Rrs: without the parent's own scale.
};

/// An FBX node and the row of nodes that assimp made of it.
struct FbxNode {
    std::vector<uint32_t> parts;  ///< In order, the one with its own name last; without those of G.
    int32_t parent = -1;          ///< The FbxNode that it hangs on, -1: none.
    FbxInherit inherit = FbxInherit::AsMatrices;
};

/// The nodes of a scene as lists, parents first, for finding and placing FBX's nodes.
struct FbxNodes {
    FbxNodes() = default;
    /// @param parents per node its parent, or -1.
    FbxNodes(const std::vector<const aiNode*>& nodes, const std::vector<int32_t>& parents);

    /// Whether every node's place is its parent's matrix times its own: always true outside FBX.
    bool areChains() const { return list.empty(); }
    /// Nodes to the world. @param locals per node: to its parent.
    std::vector<Eigen::Matrix4d> place(const std::vector<Eigen::Matrix4d>& locals,
                                       const std::vector<int32_t>& parents) const;

    std::vector<FbxNode> list;    ///< Empty if no node inherits its parent's scale in FBX's other ways.
    std::vector<int32_t> nodeOf;  ///< Per node: the FbxNode whose first part it is, or -1.
};

/// The offset of a skinned mesh in its node: G of the FBX node, which bind matrices do not contain. 1 elsewhere.
Eigen::Matrix4d geometricOffset(const aiNode& node);

/// A clip's channel for an FBX node. If assimp joins the parts of T, Rpre, R, Rpost and S into one channel for the last
/// node of the row, it keeps the nodes before it; and it forgets to invert Rpost.
struct FbxChannel {
    std::vector<const aiNode*> contained;  ///< Nodes that the channel also includes.
    /// To be multiplied to the channel's rotations on the right.
    Eigen::Matrix3d correction = Eigen::Matrix3d::Identity();
};
FbxChannel fbxChannel(const aiNode& node);

/// If a clip has no curve for an axis of a part T, R or S in a row, assimp uses 0 (1 for scale) instead of the node's
/// value. @returns the axes whose keys may be affected, such as "Lcl Translation of Hips along y"; empty if there are
/// none.
std::string axisWithoutKeys(const aiNode& node, const aiNodeAnim& channel);

}  // namespace knuckle
