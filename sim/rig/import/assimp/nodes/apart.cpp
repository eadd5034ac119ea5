#include "sim/rig/import/assimp/nodes/apart.h"

#include <fmt/format.h>

#include <span>

#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

namespace {

constexpr float MOVES = 0.2f;   // from this weight on a bone determines where a vertex is
constexpr double NEAR = 0.15;   // how far a part may stick out of a figure's bounds, over their diagonal
constexpr double BELOW = 0.02;  // the figure stands on meshes that are all below this part of its height

Eigen::Vector4d placeOf(const aiMesh& mesh, unsigned vertex)
{
    const aiVector3D& p = mesh.mVertices[vertex];
    return {p.x, p.y, p.z, 1.0};
}

/// Bounds of the meshes that are skinned to a skeleton.
Eigen::AlignedBox3d figureBounds(const aiScene& scene, const NodeTable& table)
{
    Eigen::AlignedBox3d box;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        if (mesh.mNumBones < FEWEST_SKINNED) return;
        const std::vector<Eigen::Matrix4d> matrices = skinMatrices(mesh, node, table);
        for (size_t b = 0; b < matrices.size(); ++b)
            for (const aiVertexWeight& weight : std::span(mesh.mBones[b]->mWeights, mesh.mBones[b]->mNumWeights))
                if (weight.mWeight > MOVES && weight.mVertexId < mesh.mNumVertices)
                    box.extend((matrices[b] * placeOf(mesh, weight.mVertexId)).head<3>());
    });
    return box;
}

bool isApart(const aiMesh& mesh, uint32_t node, const NodeTable& table, const Eigen::AlignedBox3d& figure)
{
    Eigen::AlignedBox3d box;
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) box.extend((table.globals[node] * placeOf(mesh, v)).head<3>());
    const Eigen::Vector3d slack = Eigen::Vector3d::Constant(NEAR * figure.diagonal().norm());
    const bool isNear = Eigen::AlignedBox3d(figure.min() - slack, figure.max() + slack).contains(box);
    return !isNear || box.max().y() < figure.min().y() + BELOW * figure.sizes().y();
}

}  // namespace

void leaveApart(const aiScene& scene, NodeTable& table, std::vector<std::string>& notes)
{
    const Eigen::AlignedBox3d figure = figureBounds(scene, table);
    if (figure.isEmpty() || !figure.sizes().allFinite()) return;
    std::set<std::pair<const aiMesh*, uint32_t>> apart;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        if (mesh.mNumBones > 0 || table.boneAbove(node) >= 0 || !isApart(mesh, node, table, figure)) return;
        apart.insert({&mesh, node});
        const std::string name = isGivenName(table.nameOf(node)) ? table.nameOf(node) : mesh.mName.C_Str();
        notes.push_back(fmt::format("Mesh '{}' hangs on no bone and lies apart from the figure: left out.", name));
    });
    table.apart = std::move(apart);
}

}  // namespace knuckle
