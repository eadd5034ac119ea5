#include "sim/rig/import/assimp/looks/surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "sim/rig/import/assimp/looks/materials.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

using Eigen::Matrix3d;
using Eigen::Matrix4d;
using Eigen::Vector3d;

namespace {

/// The matrix for normals, up to a factor above 0: the inverse transposed, made of cofactors so that flat matrices have
/// one, too.
Matrix3d normalMatrix(const Matrix4d& matrix)
{
    const Matrix3d m = matrix.topLeftCorner<3, 3>();
    Matrix3d cofactors;
    for (int i = 0; i < 3; ++i) cofactors.col(i) = m.col((i + 1) % 3).cross(m.col((i + 2) % 3));
    return m.determinant() < 0.0 ? Matrix3d(-cofactors) : cofactors;
}

/// Turns the normals of one mesh in the way of its vertices.
class NormalTurner {
public:
    NormalTurner(const aiMesh& mesh, uint32_t node, const NodeTable& table) : rigid_(normalMatrix(table.globals[node]))
    {
        if (mesh.mNumBones == 0) return;
        const std::vector<Matrix4d> matrices = skinMatrices(mesh, node, table);
        rigid_ = normalMatrix(matrices[0]);
        for (unsigned b = 0; b < mesh.mNumBones; ++b) {
            const uint32_t bone = table.boneNodes.at(mesh.mBones[b]);
            turns_[static_cast<uint32_t>(table.boneOf[bone])] = normalMatrix(matrices[b]);
        }
    }

    Vector3d turn(const aiVector3D& normal, const SkinWeights* skin) const
    {
        const Vector3d n(normal.x, normal.y, normal.z);
        Vector3d sum = Vector3d::Zero();
        for (size_t i = 0; skin != nullptr && i < skin->bones.size(); ++i) {
            const auto found = turns_.find(skin->bones[i]);
            if (skin->weights[i] > 0.0f && found != turns_.end())
                sum += double{skin->weights[i]} * (found->second * n).normalized();
        }
        return sum.squaredNorm() > 0.0 ? sum : Vector3d(rigid_ * n);
    }

private:
    Matrix3d rigid_;
    std::map<uint32_t, Matrix3d> turns_;  ///< By index in Model::bones.
};

Eigen::Vector2f uvOf(const aiVector3D& uv, const Eigen::Affine2f& moved)
{
    const Eigen::Vector2f place = moved * Eigen::Vector2f(uv.x, 1.0f - uv.y);
    // With more repetitions, floats would have no digits left for the place in the picture.
    return place.allFinite() && place.cwiseAbs().maxCoeff() < 1e4f ? place : Eigen::Vector2f(0, 0);
}

Eigen::Vector3f colorOf(const aiColor4D& color)
{
    const Eigen::Vector3f rgb(color.r, color.g, color.b);
    return rgb.allFinite() ? Eigen::Vector3f(rgb.cwiseMax(0.0f).cwiseMin(1.0f)) : Eigen::Vector3f(1, 1, 1);
}

}  // namespace

void convertSurface(const aiScene& scene, const NodeTable& table, const std::string& path, Model& model)
{
    const std::vector<ConvertedMaterial> materials = convertMaterials(scene, table, path, model);
    ModelSurface& surface = model.surface;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        const NormalTurner turner(mesh, node, table);
        const ConvertedMaterial& material = materials.at(mesh.mMaterialIndex);
        const unsigned channel = mesh.HasTextureCoords(material.uvChannel) ? material.uvChannel : 0;
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            SurfaceVertex vertex;
            const size_t index = surface.vertices.size();
            const SkinWeights* skin = model.skin.empty() ? nullptr : &model.skin[index];
            if (mesh.HasNormals()) {
                const Vector3d normal = turner.turn(mesh.mNormals[v], skin);
                if (normal.allFinite() && normal.norm() > 0.0) vertex.normal = normal.normalized().cast<float>();
            }
            if (mesh.HasTextureCoords(channel)) vertex.uv = uvOf(mesh.mTextureCoords[channel][v], material.moved);
            if (mesh.HasVertexColors(0)) vertex.color = colorOf(mesh.mColors[0][v]);
            vertex.material = material.index;
            surface.vertices.push_back(vertex);
        }
    });
}

}  // namespace knuckle
