#include "sim/rig/gltf/gltf_mesh.h"

#include <algorithm>
#include <array>
#include <map>

#include "sim/rig/gltf/gltf_clips.h"

namespace knuckle {

namespace {

constexpr size_t WEIGHTS = 4;  // of a glTF attribute
constexpr size_t MOST_SHORT = 65535, MOST_BYTE = 255;

/// An accessor in the smallest type that holds all values.
size_t addIndices(GltfFile& file, const std::vector<uint32_t>& values, size_t largest)
{
    if (largest >= MOST_SHORT)
        return file.addAccessor(values, 1, GLTF_UNSIGNED_INT, "SCALAR", GLTF_ELEMENT_ARRAY_BUFFER);
    return file.addAccessor(std::vector<uint16_t>(values.begin(), values.end()), 1, GLTF_UNSIGNED_SHORT, "SCALAR",
                            GLTF_ELEMENT_ARRAY_BUFFER);
}

void addPositions(GltfFile& file, const Model& model, GltfJson& attributes)
{
    std::vector<float> positions;
    Eigen::Vector3f low = model.vertices.front(), high = low;
    for (const Eigen::Vector3f& vertex : model.vertices) {
        appendTo(positions, vertex);
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    const size_t accessor = file.addAccessor(positions, 3, GLTF_FLOAT, "VEC3", GLTF_ARRAY_BUFFER);
    file.setBounds(accessor, gltfArray(low), gltfArray(high));
    attributes["POSITION"] = accessor;
}

void addLooks(GltfFile& file, const ModelSurface& surface, GltfJson& attributes)
{
    std::vector<float> normals, uvs, colors;
    bool colored = false;
    for (const SurfaceVertex& vertex : surface.vertices) {
        appendTo(normals, vertex.normal);
        appendTo(uvs, vertex.uv);
        appendTo(colors, vertex.color);
        colored = colored || vertex.color != Eigen::Vector3f(1, 1, 1);
    }
    attributes["NORMAL"] = file.addAccessor(normals, 3, GLTF_FLOAT, "VEC3", GLTF_ARRAY_BUFFER);
    if (!surface.textures.empty())
        attributes["TEXCOORD_0"] = file.addAccessor(uvs, 2, GLTF_FLOAT, "VEC2", GLTF_ARRAY_BUFFER);
    if (colored) attributes["COLOR_0"] = file.addAccessor(colors, 3, GLTF_FLOAT, "VEC3", GLTF_ARRAY_BUFFER);
}

/// Adds the four largest weights of a vertex, scaled to sum to one.
void addWeights(GltfFile& file, const Model& model, GltfJson& attributes)
{
    std::vector<uint16_t> joints;
    std::vector<float> weights;
    for (const SkinWeights& skin : model.skin) {
        std::array<std::pair<float, uint32_t>, 8> order;
        for (size_t i = 0; i < order.size(); ++i) order[i] = {-skin.weights[i], skin.bones[i]};
        std::ranges::sort(order);
        float sum = 0.0f;
        for (size_t i = 0; i < WEIGHTS; ++i) sum -= order[i].first;
        for (size_t i = 0; i < WEIGHTS; ++i) {
            const float weight = sum > 0.0f ? -order[i].first / sum : (i == 0 ? 1.0f : 0.0f);
            // A joint without weight must be 0.
            joints.push_back(weight > 0.0f ? static_cast<uint16_t>(order[i].second) : uint16_t{0});
            weights.push_back(weight);
        }
    }
    if (model.bones.size() <= MOST_BYTE)
        attributes["JOINTS_0"] = file.addAccessor(std::vector<uint8_t>(joints.begin(), joints.end()), WEIGHTS,
                                                  GLTF_UNSIGNED_BYTE, "VEC4", GLTF_ARRAY_BUFFER);
    else attributes["JOINTS_0"] = file.addAccessor(joints, WEIGHTS, GLTF_UNSIGNED_SHORT, "VEC4", GLTF_ARRAY_BUFFER);
    attributes["WEIGHTS_0"] = file.addAccessor(weights, WEIGHTS, GLTF_FLOAT, "VEC4", GLTF_ARRAY_BUFFER);
}

/// @returns the index of the material's texture with that picture.
size_t addTexture(GltfFile& file, size_t picture, const SkinMaterial& material)
{
    GltfJson texture{{"source", picture}};
    if (material.wrap != SkinMaterial().wrap) {
        const auto mode = [](TextureWrap wrap) {
            return wrap == TextureWrap::Clamp ? GLTF_CLAMP_TO_EDGE
                                              : (wrap == TextureWrap::Mirror ? GLTF_MIRRORED_REPEAT : GLTF_REPEAT);
        };
        texture["sampler"] = file.appendOnce("samplers",
                                             {{"wrapS", mode(material.wrap[0])}, {"wrapT", mode(material.wrap[1])}});
    }
    return file.appendOnce("textures", std::move(texture));
}

/// The materials of a model. @returns the index of the first one.
size_t addMaterials(GltfFile& file, const ModelSurface& surface, const GlbOptions& options)
{
    const size_t first = file.count("materials");
    std::map<uint32_t, size_t> pictures;
    for (const SkinMaterial& material : surface.materials) {
        GltfJson rough{{"baseColorFactor", {material.color.x(), material.color.y(), material.color.z(), 1.0f}},
                       {"metallicFactor", 0.0f},
                       {"roughnessFactor", 0.8f}};
        if (material.texture < surface.textures.size() && options.encode) {
            if (!pictures.contains(material.texture))
                pictures[material.texture] = file.addPng(options.encode(surface.textures[material.texture]),
                                                         material.name);
            rough["baseColorTexture"] = {{"index", addTexture(file, pictures[material.texture], material)}};
        }
        GltfJson entry{{"name", material.name}, {"pbrMetallicRoughness", std::move(rough)}};
        if (material.twoSided) entry["doubleSided"] = true;
        if (material.alphaCutoff > 0.0f) {
            entry["alphaMode"] = "MASK";
            entry["alphaCutoff"] = material.alphaCutoff;
        }
        file.append("materials", std::move(entry));
    }
    return first;
}

/// A primitive for each material that has triangles.
GltfJson primitivesOf(GltfFile& file, const Model& model, const GltfJson& attributes, size_t firstMaterial)
{
    std::map<uint32_t, std::vector<uint32_t>> byMaterial;
    const bool looks = !model.surface.vertices.empty() && !model.surface.materials.empty();
    for (const auto& triangle : model.triangles) {
        std::vector<uint32_t>& indices = byMaterial[looks ? model.surface.vertices[triangle[0]].material : 0];
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    GltfJson primitives = GltfJson::array();
    for (const auto& [material, indices] : byMaterial) {
        GltfJson primitive{{"attributes", attributes}, {"indices", addIndices(file, indices, model.vertices.size())}};
        if (looks) primitive["material"] = firstMaterial + material;
        primitives.push_back(std::move(primitive));
    }
    return primitives;
}

size_t addSkin(GltfFile& file, const Model& model, size_t firstBone)
{
    std::vector<float> binds;
    GltfJson joints = GltfJson::array();
    for (size_t b = 0; b < model.bones.size(); ++b) {
        appendTo(binds, Eigen::Matrix4f(rigidPose(model.bones[b].restPose).inverse()));
        joints.push_back(firstBone + b);
    }
    const size_t accessor = file.addAccessor(binds, 16, GLTF_FLOAT, "MAT4");
    return file.append("skins", {{"joints", std::move(joints)}, {"inverseBindMatrices", accessor}});
}

}  // namespace

size_t addMesh(GltfFile& file, const Model& model, size_t firstBone, const GlbOptions& options)
{
    const bool skinned = model.skin.size() == model.vertices.size() && !model.bones.empty();
    GltfJson attributes;
    addPositions(file, model, attributes);
    size_t firstMaterial = 0;
    if (model.surface.vertices.size() == model.vertices.size()) {
        addLooks(file, model.surface, attributes);
        firstMaterial = addMaterials(file, model.surface, options);
    }
    if (skinned) addWeights(file, model, attributes);
    GltfJson primitives = primitivesOf(file, model, attributes, firstMaterial);
    const size_t mesh = file.append("meshes", {{"name", model.name}, {"primitives", std::move(primitives)}});
    GltfJson node{{"name", model.name}, {"mesh", mesh}};
    if (skinned) node["skin"] = addSkin(file, model, firstBone);
    return file.append("nodes", std::move(node));
}

}  // namespace knuckle
