#include "sim/rig/import/assimp/nodes/shown_meshes.h"

#include <fmt/format.h>

#include "sim/base/errors.h"

namespace knuckle {

using Eigen::Matrix4d;

namespace {

constexpr double SINGULAR = 1e-9;  // smallest over largest singular value of a bind matrix

}  // namespace

std::vector<Matrix4d> skinMatrices(const aiMesh& mesh, uint32_t node, const NodeTable& table)
{
    const Matrix4d offset = geometricOffset(*table.nodes[node]);
    std::vector<Matrix4d> matrices;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        const aiBone& bone = *mesh.mBones[b];
        const Matrix4d bind = toEigen(bone.mOffsetMatrix);
        const Matrix4d matrix = table.globals[table.boneNodes.at(&bone)] * bind * offset;
        bool moves = false;
        for (unsigned w = 0; w < bone.mNumWeights; ++w) {
            moves = moves || bone.mWeights[w].mWeight > 0.0f;
        }
        const Eigen::Vector3d stretch = bind.topLeftCorner<3, 3>().colwise().norm();
        const double volume = std::abs(bind.topLeftCorner<3, 3>().determinant());
        const bool sound = matrix.allFinite() && volume > SINGULAR * std::pow(stretch.maxCoeff(), 3.0) && volume > 0.0;
        if (moves && !sound) {
            throw InputError(fmt::format("bone '{}' has a bind matrix that is singular or not a number: export the "
                                         "model again",
                                         bone.mName.C_Str()));
        }
        matrices.push_back(matrix);
    }
    return matrices;
}

void forEachMesh(const aiScene& scene, const NodeTable& table,
                 const std::function<void(const aiMesh&, uint32_t)>& visit)
{
    if (table.isBare) return;
    std::vector<bool> shown(scene.mNumMeshes, false);
    for (uint32_t n = 0; n < table.nodes.size(); ++n) {
        for (unsigned m = 0; m < table.nodes[n]->mNumMeshes; ++m) {
            const unsigned index = table.nodes[n]->mMeshes[m];
            if (index >= scene.mNumMeshes || (scene.mMeshes[index]->mNumBones > 0 && shown[index])) {
                continue;
            }
            shown[index] = true;
            if (table.takes(*scene.mMeshes[index], n)) visit(*scene.mMeshes[index], n);
        }
    }
}

}  // namespace knuckle
