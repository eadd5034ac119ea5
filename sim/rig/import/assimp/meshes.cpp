#include "sim/rig/import/assimp/meshes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "sim/base/errors.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"

namespace knuckle {

using Eigen::Matrix4d;
using Eigen::Vector4d;

namespace {

constexpr size_t VERTEX_LIMIT = 4000000;
constexpr size_t TRIANGLE_LIMIT = 8000000;
constexpr double WEIGHT_SLACK = 0.01;  // sums this near to 1 are not worth a note

struct Influence {
    uint32_t bone = 0;  // of the mesh, not of the model
    double weight = 0.0;
};

struct SkinNotes {
    size_t dropped = 0;     // weights that were negative or not numbers
    size_t scaled = 0;      // vertices whose weights did not sum to 1
    size_t unweighted = 0;  // vertices that no bone moves, in a skinned mesh
};

std::vector<std::vector<Influence>> influencesOf(const aiMesh& mesh, SkinNotes& notes)
{
    std::vector<std::vector<Influence>> influences(mesh.mNumVertices);
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        for (unsigned w = 0; w < mesh.mBones[b]->mNumWeights; ++w) {
            const aiVertexWeight& weight = mesh.mBones[b]->mWeights[w];
            if (weight.mVertexId >= mesh.mNumVertices) {
                throw InputError(fmt::format("bone '{}' weighs vertex {} of mesh '{}', which has {}",
                                             mesh.mBones[b]->mName.C_Str(), weight.mVertexId, mesh.mName.C_Str(),
                                             mesh.mNumVertices));
            }
            if (std::isfinite(weight.mWeight) && weight.mWeight > 0.0f) {
                influences[weight.mVertexId].push_back({b, weight.mWeight});
            } else if (weight.mWeight != 0.0f) {
                ++notes.dropped;
            }
        }
    }
    return influences;
}

// Keeps the strongest eight, scaled to sum 1.
void normalize(std::vector<Influence>& influences, SkinNotes& notes)
{
    std::stable_sort(influences.begin(), influences.end(),
                     [](const Influence& a, const Influence& b) { return a.weight > b.weight; });
    double sum = 0.0;
    for (const Influence& influence : influences) {
        sum += influence.weight;
    }
    notes.scaled += std::abs(sum - 1.0) > WEIGHT_SLACK;
    influences.resize(std::min(influences.size(), SkinWeights{}.bones.size()));
    sum = 0.0;
    for (const Influence& influence : influences) {
        sum += influence.weight;
    }
    for (Influence& influence : influences) {
        influence.weight /= sum;
    }
}

uint32_t nearestBone(const Model& model, const Eigen::Vector3f& position)
{
    float best = std::numeric_limits<float>::infinity();
    uint32_t nearest = 0;
    for (uint32_t b = 0; b < model.bones.size(); ++b) {
        const float distance = (boneHead(model, b) - position).norm();
        if (distance < best) {
            best = distance;
            nearest = b;
        }
    }
    return nearest;
}

void addVertex(const Vector4d& position, const aiMesh& mesh, Model& model)
{
    if (!position.allFinite() || position.head<3>().cwiseAbs().maxCoeff() > std::numeric_limits<float>::max()) {
        throw InputError(fmt::format("mesh '{}' has vertices that are not finite numbers: export the model again",
                                     mesh.mName.C_Str()));
    }
    model.vertices.push_back(position.head<3>().cast<float>());
}

/// 1 for a matrix that keeps right-handedness, -1 for one that mirrors.
double handOf(const Matrix4d& matrix)
{
    return matrix.topLeftCorner<3, 3>().determinant() < 0.0 ? -1.0 : 1.0;
}

/// @param hands per vertex: handOf() its matrix. Reverses triangles whose vertices are mirrored.
void addTriangles(const aiMesh& mesh, size_t firstVertex, const std::vector<double>& hands, Model& model)
{
    for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
        const aiFace& face = mesh.mFaces[f];
        if (face.mNumIndices != 3) {
            continue;  // points and lines enclose nothing
        }
        std::array<uint32_t, 3> triangle;
        double hand = 0.0;
        for (unsigned i = 0; i < 3; ++i) {
            if (face.mIndices[i] >= mesh.mNumVertices) {
                throw InputError(fmt::format("mesh '{}' names vertex {}, it has {}", mesh.mName.C_Str(),
                                             face.mIndices[i], mesh.mNumVertices));
            }
            triangle[i] = static_cast<uint32_t>(firstVertex) + face.mIndices[i];
            hand += hands[face.mIndices[i]];
        }
        if (hand < 0.0) std::swap(triangle[1], triangle[2]);
        model.triangles.push_back(triangle);
    }
    if (model.triangles.size() > TRIANGLE_LIMIT) {
        throw InputError(fmt::format("it has more than {} triangles: simplify it", TRIANGLE_LIMIT));
    }
}

void addSkinned(const aiMesh& mesh, uint32_t node, const NodeTable& table, Model& model, SkinNotes& notes)
{
    const std::vector<Matrix4d> matrices = skinMatrices(mesh, node, table);
    std::vector<std::vector<Influence>> influences = influencesOf(mesh, notes);
    std::vector<uint32_t> boneIndices;
    for (unsigned b = 0; b < mesh.mNumBones; ++b) {
        boneIndices.push_back(static_cast<uint32_t>(table.boneOf[table.boneNodes.at(mesh.mBones[b])]));
    }
    const size_t first = model.vertices.size();
    std::vector<double> hands(mesh.mNumVertices, 0.0);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& p = mesh.mVertices[v];
        const Vector4d local(p.x, p.y, p.z, 1.0);
        SkinWeights skin;
        Vector4d position = Vector4d::Zero();
        if (influences[v].empty()) {
            ++notes.unweighted;
            addVertex(matrices[0] * local, mesh, model);
            hands[v] = handOf(matrices[0]);
            const int32_t above = table.boneAbove(node);
            skin.bones[0] = above >= 0 ? static_cast<uint32_t>(above) : nearestBone(model, model.vertices.back());
            skin.weights[0] = 1.0f;
        } else {
            normalize(influences[v], notes);
            for (size_t i = 0; i < influences[v].size(); ++i) {
                const Influence& influence = influences[v][i];
                position += influence.weight * (matrices[influence.bone] * local);
                hands[v] += influence.weight * handOf(matrices[influence.bone]);
                skin.bones[i] = boneIndices[influence.bone];
                skin.weights[i] = static_cast<float>(influence.weight);
            }
            addVertex(position, mesh, model);
        }
        model.skin.push_back(skin);
    }
    addTriangles(mesh, first, hands, model);
}

void addRigid(const aiMesh& mesh, uint32_t node, const NodeTable& table, Model& model)
{
    const Matrix4d& matrix = table.globals[node];
    const size_t first = model.vertices.size();
    const int32_t above = table.boneAbove(node);
    for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
        const aiVector3D& p = mesh.mVertices[v];
        addVertex(matrix * Vector4d(p.x, p.y, p.z, 1.0), mesh, model);
        if (!model.bones.empty()) {
            SkinWeights skin;
            skin.bones[0] = above >= 0 ? static_cast<uint32_t>(above) : nearestBone(model, model.vertices.back());
            skin.weights[0] = 1.0f;
            model.skin.push_back(skin);
        }
    }
    addTriangles(mesh, first, std::vector(mesh.mNumVertices, handOf(matrix)), model);
}

}  // namespace

void convertMeshes(const aiScene& scene, const NodeTable& table, Model& model)
{
    SkinNotes notes;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t node) {
        if (model.vertices.size() + mesh.mNumVertices > VERTEX_LIMIT) {
            throw InputError(fmt::format("it has more than {} vertices: simplify it", VERTEX_LIMIT));
        }
        const size_t before = model.triangles.size();
        if (mesh.mNumBones > 0) {
            addSkinned(mesh, node, table, model, notes);
        } else {
            addRigid(mesh, node, table, model);
        }
        if (model.triangles.size() == before) {
            model.notes.push_back(fmt::format("Mesh '{}' has no triangles and fills nothing.", mesh.mName.C_Str()));
        }
    });
    if (notes.scaled > 0) {
        model.notes.push_back(fmt::format("Weights of {} vertices did not sum to 1 and were scaled.", notes.scaled));
    }
    if (notes.dropped > 0) {
        model.notes.push_back(fmt::format("{} weights were negative or not numbers and were dropped.", notes.dropped));
    }
    if (notes.unweighted > 0) {
        model.notes.push_back(
            fmt::format("{} vertices had no weights and went to the nearest bone.", notes.unweighted));
    }
}

}  // namespace knuckle
