#include "sim/rig/import/assimp/nodes/fbx_nodes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <string_view>

#include "sim/rig/import/assimp/nodes/node_table.h"

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

namespace {

constexpr std::string_view PIVOT = "_$AssimpFbx$_";
constexpr double SAME = 1e-9;       // of a scale that is 1
constexpr double SINGULAR = 1e-12;  // of a determinant, over the cube of the longest column

/// The part of a node's name after that of its FBX node: "PreRotation"; empty for the FBX node's own name.
std::string_view partName(const aiNode& node)
{
    const std::string_view name(node.mName.data, node.mName.length);
    const size_t tag = name.find(PIVOT);
    return tag == std::string_view::npos ? std::string_view{} : name.substr(tag + PIVOT.size());
}

std::string_view ownName(const aiNode& node)
{
    const std::string_view name(node.mName.data, node.mName.length);
    return name.substr(0, name.find(PIVOT));
}

bool isGeometric(const aiNode& node)
{
    return partName(node).starts_with("Geometric");
}

/// The parts before the node with the FBX node's own name, the nearest first.
std::vector<const aiNode*> partsBefore(const aiNode& node)
{
    std::vector<const aiNode*> parts;
    for (const aiNode* n = node.mParent; n != nullptr && !partName(*n).empty() && ownName(*n) == ownName(node);
         n = n->mParent)
        parts.push_back(n);
    return parts;
}

FbxInherit inheritOf(const aiNode& node)
{
    int32_t type = 1;
    if (node.mMetaData != nullptr) node.mMetaData->Get("InheritType", type);
    if (type == 0) return FbxInherit::AfterRotation;
    return type == 2 ? FbxInherit::NotTheParents : FbxInherit::AsMatrices;
}

/// Takes a matrix that scales first and then turns apart.
struct TurnAndScale {
    explicit TurnAndScale(const Matrix3d& m)
        : scale((m.determinant() < 0.0 ? -1.0 : 1.0) * m.colwise().norm().transpose()),
          turn(m * scale.unaryExpr([](double s) { return s != 0.0 ? 1.0 / s : 0.0; }).asDiagonal())
    {
    }
    Vector3d scale;
    Matrix3d turn;
};

/// Turn and scale of an FBX node in the world.
struct Standing {
    Matrix3d turn = Matrix3d::Identity();   ///< All rotations, without scales.
    Matrix3d scale = Matrix3d::Identity();  ///< The product of all scales, before the turn.
    Vector3d own = Vector3d::Ones();        ///< The node's own scale.
};

/// The axis whose keys are all `missing` although the node has another value; -1: none.
template <typename Key, typename Value>
int axisOf(const Key* keys, unsigned count, const Vector3d& own, double missing, const Value& valueOf)
{
    constexpr double ZERO = 1e-5;  // a rotation of none, as floats have it
    for (int axis = 0; axis < 3; ++axis)
        if (count > 0 && std::abs(own[axis] - missing) > ZERO &&
            std::all_of(keys, keys + count, [&](const Key& key) { return double(valueOf(key)[axis]) == missing; }))
            return axis;
    return -1;
}

Standing standingIn(const Standing& parent, FbxInherit inherit, const Matrix3d& linear)
{
    const TurnAndScale own(linear);
    Standing standing{parent.turn * own.turn, {}, own.scale};
    const Matrix3d all = own.scale.asDiagonal();
    switch (inherit) {
        case FbxInherit::AfterRotation: standing.scale = parent.scale * all; break;
        case FbxInherit::AsMatrices: standing.scale = own.turn.transpose() * parent.scale * own.turn * all; break;
        case FbxInherit::NotTheParents: {
            const Vector3d undone = parent.own.unaryExpr([](double s) { return s != 0.0 ? 1.0 / s : 1.0; });
            standing.scale = parent.scale * undone.asDiagonal() * all;
        }
    }
    return standing;
}

}  // namespace

bool isPivot(const std::string& name)
{
    return name.find(PIVOT) != std::string::npos;
}

FbxNodes::FbxNodes(const std::vector<const aiNode*>& nodes, const std::vector<int32_t>& parents)
{
    std::vector<int32_t> standsOn(nodes.size(), -1);  // per node: the FbxNode whose part or offset it is
    nodeOf.assign(nodes.size(), -1);
    bool isNeeded = false;
    for (uint32_t n = 0; n < nodes.size(); ++n) {
        const int32_t above = parents[n] < 0 ? -1 : standsOn[static_cast<size_t>(parents[n])];
        const bool goesOn = above >= 0 && !partName(*nodes[static_cast<size_t>(parents[n])]).empty() &&
                            ownName(*nodes[n]) == ownName(*nodes[static_cast<size_t>(parents[n])]);
        const bool isOffsetUndone = above >= 0 && partName(*nodes[n]).ends_with("Inverse") && isGeometric(*nodes[n]);
        if (!goesOn && !isOffsetUndone) {
            nodeOf[n] = static_cast<int32_t>(list.size());
            list.push_back({{}, above});
        }
        standsOn[n] = goesOn || isOffsetUndone ? above : nodeOf[n];
        FbxNode& own = list[static_cast<size_t>(standsOn[n])];
        if (isGeometric(*nodes[n])) continue;
        own.parts.push_back(n);
        if (partName(*nodes[n]).empty()) own.inherit = inheritOf(*nodes[n]);
        isNeeded = isNeeded || own.inherit != FbxInherit::AsMatrices;
    }
    if (isNeeded) return;
    list.clear();
    nodeOf.clear();
}

std::vector<Matrix4d> FbxNodes::place(const std::vector<Matrix4d>& locals, const std::vector<int32_t>& parents) const
{
    std::vector<Matrix4d> globals(locals.size());
    std::vector<Standing> standings(list.size());
    for (size_t n = 0; n < locals.size(); ++n) {
        Matrix4d above = parents[n] < 0 ? Matrix4d(Matrix4d::Identity()) : globals[static_cast<size_t>(parents[n])];
        if (!areChains() && nodeOf[n] >= 0) {
            const FbxNode& node = list[static_cast<size_t>(nodeOf[n])];
            Matrix4d own = Matrix4d::Identity();
            for (const uint32_t part : node.parts) own = own * locals[part];
            const Standing parent = node.parent < 0 ? Standing{} : standings[static_cast<size_t>(node.parent)];
            const Matrix3d linear = own.topLeftCorner<3, 3>();
            const Standing& standing = standings[static_cast<size_t>(nodeOf[n])] = standingIn(parent, node.inherit,
                                                                                              linear);
            const double longest = linear.colwise().norm().maxCoeff();
            const bool isPlain = node.inherit == FbxInherit::AsMatrices || parent.scale.isIdentity(SAME);
            if (!isPlain && std::abs(linear.determinant()) > SINGULAR * longest * longest * longest) {
                // The whole row has to end in the right place: the matrix before its first part compensates.
                Matrix4d wanted = above * own;
                wanted.topLeftCorner<3, 3>() = standing.turn * standing.scale;
                above = wanted * own.inverse();
            }
        }
        globals[n] = parents[n] < 0 ? locals[n] : Matrix4d(above * locals[n]);
    }
    return globals;
}

Matrix4d geometricOffset(const aiNode& node)
{
    Matrix4d offset = Matrix4d::Identity();
    for (const aiNode* part : partsBefore(node))
        if (isGeometric(*part)) offset = toEigen(part->mTransformation) * offset;
    return offset;
}

FbxChannel fbxChannel(const aiNode& node)
{
    FbxChannel channel;
    if (!partName(node).empty()) return channel;
    for (const aiNode* part : partsBefore(node)) {
        if (isGeometric(*part)) continue;
        channel.contained.push_back(part);
        // This node holds the inverse: once to undo the channel's wrong one, once as the correct one.
        const Matrix3d inverse = toEigen(part->mTransformation).topLeftCorner<3, 3>();
        if (partName(*part) == "PostRotation") channel.correction = inverse * inverse;
    }
    return channel;
}

std::string axisWithoutKeys(const aiNode& node, const aiNodeAnim& channel)
{
    const std::string_view part = partName(node);
    const Matrix4d own = toEigen(node.mTransformation);
    const auto vector = [](const aiVectorKey& key) { return Vector3d(key.mValue.x, key.mValue.y, key.mValue.z); };
    const auto turn = [](const aiQuatKey& key) { return Vector3d(key.mValue.x, key.mValue.y, key.mValue.z); };
    int axis = -1;
    if (part == "Translation")
        axis = axisOf(channel.mPositionKeys, channel.mNumPositionKeys, own.topRightCorner<3, 1>(), 0.0, vector);
    if (part == "Rotation") {
        const Eigen::Quaterniond rotation(Matrix3d(own.topLeftCorner<3, 3>()));
        axis = axisOf(channel.mRotationKeys, channel.mNumRotationKeys, rotation.vec(), 0.0, turn);
    }
    if (part == "Scaling")
        axis = axisOf(channel.mScalingKeys, channel.mNumScalingKeys, own.topLeftCorner<3, 3>().diagonal(), 1.0, vector);
    return axis < 0 ? "" : fmt::format("Lcl {} of {} along {}", part, ownName(node), "xyz"[axis]);
}

}  // namespace knuckle
