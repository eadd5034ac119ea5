#include "sim/rig/import/assimp/looks/materials.h"

#include <assimp/GltfMaterial.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <set>

#include "sim/base/colors.h"
#include "sim/rig/import/assimp/looks/texture_decoder.h"
#include "sim/rig/import/assimp/nodes/shown_meshes.h"
#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr uintmax_t PICTURE_FILE_LIMIT = 256ull << 20;  // [bytes]
constexpr size_t PIXEL_LIMIT = 16u << 20;               // of all pictures of a model
constexpr float NOTHING_LEFT = 2.0f;                    // a cutoff above any alpha
constexpr float BLENDED_CUTOFF = 0.5f;                  // for materials that the file blends

/// Reads each picture of a scene once, however many materials name it.
class TextureReader {
public:
    TextureReader(const aiScene& scene, const std::string& modelPath, Model& model)
        : scene_(scene), folder_(fs::path(modelPath).parent_path()), model_(model)
    {
    }

    /// @returns the index of its picture; NO_INDEX, and a note, if it cannot be read.
    uint32_t read(const std::string& name)
    {
        const auto [entry, isNew] = indices_.emplace(name, NO_INDEX);
        if (isNew) entry->second = add(name);
        return entry->second;
    }

private:
    uint32_t add(const std::string& name)
    {
        std::string why = "is damaged or of a kind that is not read (PNG, JPEG, WebP, TGA, BMP and PSD are)";
        std::optional<TexturePicture> picture = find(name, why);
        if (!picture) return missing(name, why);
        const uint32_t width = picture->width, height = picture->height;
        while (std::max(picture->width, picture->height) > TEXTURE_SIDE) *picture = halved(*picture);
        const size_t pixels = size_t{picture->width} * picture->height;
        if (pixels_ + pixels > PIXEL_LIMIT)
            return missing(name, fmt::format("is one too many: {} million pixels are read", PIXEL_LIMIT >> 20));
        pixels_ += pixels;
        if (picture->width < width)
            model_.surface.notes.push_back(fmt::format("Texture '{}' of {} x {} pixels is drawn as {} x {}.", name,
                                                       width, height, picture->width, picture->height));
        model_.surface.textures.push_back(std::move(*picture));
        return static_cast<uint32_t>(model_.surface.textures.size() - 1);
    }

    uint32_t missing(const std::string& name, const std::string& why)
    {
        model_.surface.missing.push_back(fmt::format("Texture '{}' {}: drawn plain.", name, why));
        return NO_INDEX;
    }

    std::optional<TexturePicture> find(const std::string& name, std::string& why) const
    {
        if (const aiTexture* embedded = scene_.GetEmbeddedTexture(name.c_str())) return decode(*embedded);
        const std::optional<fs::path> file = beside(name);
        if (!file) {
            why = "is not there";
            return {};
        }
        std::error_code error;
        if (fs::file_size(*file, error) > PICTURE_FILE_LIMIT || error) return {};
        std::ifstream stream(*file, std::ios::binary);
        const std::vector<char> bytes{std::istreambuf_iterator<char>(stream), {}};
        return decodeTexture({reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size()});
    }

    static std::optional<TexturePicture> decode(const aiTexture& texture)
    {
        const auto* bytes = reinterpret_cast<const uint8_t*>(texture.pcData);
        if (texture.mHeight == 0) return decodeTexture({bytes, texture.mWidth});
        if (std::max(texture.mWidth, texture.mHeight) > unsigned{DECODED_SIDE} || texture.mWidth == 0) return {};
        TexturePicture picture{texture.mWidth, texture.mHeight, {}};
        for (size_t i = 0; i < size_t{texture.mWidth} * texture.mHeight; ++i) {
            const aiTexel& texel = texture.pcData[i];
            picture.rgba.insert(picture.rgba.end(), {texel.r, texel.g, texel.b, texel.a});
        }
        return picture;
    }

    /// The file at the given path, or right beside the model: paths in models are often those of another computer.
    std::optional<fs::path> beside(std::string name) const
    {
        std::ranges::replace(name, '\\', '/');
        for (const fs::path wanted : {name, decodedUri(name)}) {
            for (const fs::path& path : {folder_ / wanted, folder_ / wanted.filename()}) {
                std::error_code error;
                if (fs::is_regular_file(path, error)) return path;
            }
        }
        return {};
    }

    const aiScene& scene_;
    fs::path folder_;
    Model& model_;
    size_t pixels_ = 0;
    std::map<std::string, uint32_t> indices_;
};

/// Colours that are not given as linear are sRGB, as picked on a screen.
Eigen::Vector3f plainColor(const aiColor4D& color, bool isLinear)
{
    Eigen::Vector3f rgb(color.r, color.g, color.b);
    if (!rgb.allFinite()) return {0.8f, 0.8f, 0.8f};
    rgb = rgb.cwiseMax(0.0f).cwiseMin(1.0f);
    return isLinear ? rgb : Eigen::Vector3f(rgb.unaryExpr(&linearOfSrgb<float>));
}

/// The color that multiplies the picture. A black material that glows has the color of its glow.
struct MaterialColor {
    Eigen::Vector3f rgb{0.8f, 0.8f, 0.8f};
    float alpha = 1.0f;
    bool isGlow = false;
};

MaterialColor colorOf(const aiMaterial& material)
{
    constexpr float BLACK = 1e-3f;
    aiColor4D color(0.8f, 0.8f, 0.8f, 1.0f), glow(0.0f, 0.0f, 0.0f, 1.0f);
    const bool isLinear = material.Get(AI_MATKEY_BASE_COLOR, color) == aiReturn_SUCCESS;
    if (!isLinear) material.Get(AI_MATKEY_COLOR_DIFFUSE, color);
    MaterialColor found{plainColor(color, isLinear), std::isfinite(color.a) ? color.a : 1.0f, false};
    const bool glows = material.Get(AI_MATKEY_COLOR_EMISSIVE, glow) == aiReturn_SUCCESS;
    if (!glows || found.rgb.maxCoeff() > BLACK || plainColor(glow, isLinear).maxCoeff() <= BLACK) return found;
    return {plainColor(glow, isLinear), found.alpha, true};
}

/// Both sides are visible if the file says nothing.
bool isTwoSided(const aiMaterial& material)
{
    int twoSided = 1;
    material.Get(AI_MATKEY_TWOSIDED, twoSided);
    return twoSided != 0;
}

float alphaCutoffOf(const aiMaterial& material)
{
    aiString mode;
    if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) != aiReturn_SUCCESS) return 0.0f;
    if (mode == aiString("BLEND")) return BLENDED_CUTOFF;
    float cutoff = 0.0f;
    if (mode == aiString("MASK")) material.Get(AI_MATKEY_GLTF_ALPHACUTOFF, cutoff);
    return std::isfinite(cutoff) ? std::clamp(cutoff, 0.0f, NOTHING_LEFT) : 0.0f;
}

/// The cutoff for the picture's alpha alone, which is 1 without a picture.
float cutoffOf(const SkinMaterial& material, float alpha)
{
    const float cutoff = alpha > 0.0f ? std::min(material.alphaCutoff / std::min(alpha, 1.0f), NOTHING_LEFT)
                                      : (material.alphaCutoff > 0.0f ? NOTHING_LEFT : 0.0f);
    return material.texture == NO_INDEX && cutoff <= 1.0f ? 0.0f : cutoff;
}

TextureWrap wrapOf(aiTextureMapMode mode)
{
    return mode == aiTextureMapMode_Mirror
               ? TextureWrap::Mirror
               : (mode == aiTextureMapMode_Clamp ? TextureWrap::Clamp : TextureWrap::Repeat);
}

/// Whether the same picture also cuts out parts of the material, as in FBX.
bool isCutOut(const aiMaterial& material, const aiString& picture)
{
    aiString opacity;
    return material.GetTexture(aiTextureType_OPACITY, 0, &opacity) == aiReturn_SUCCESS && opacity == picture;
}

/// glTF's KHR_texture_transform, from assimp's version of it for places whose v points upwards. (Assimp's own step that
/// moves places loses shifts.)
Eigen::Affine2f movedBy(const aiUVTransform& transform)
{
    const float cosine = std::cos(-transform.mRotation), sine = std::sin(-transform.mRotation);
    const Eigen::Vector2f scale(transform.mScaling.x, transform.mScaling.y);
    Eigen::Affine2f moved = Eigen::Affine2f::Identity();
    moved.linear() << cosine, sine, -sine, cosine;
    moved.linear() *= scale.asDiagonal();
    moved.translation() << transform.mTranslation.x - 0.5f * scale.x() * (1.0f - cosine + sine),
        1.0f - scale.y() - transform.mTranslation.y + 0.5f * scale.y() * (sine + cosine - 1.0f);
    return moved.matrix().allFinite() ? moved : Eigen::Affine2f::Identity();
}

/// 0 ... 1; below 0: not given.
float factorOf(const aiMaterial& material, const char* key, unsigned type, unsigned index)
{
    ai_real value = -1.0f;
    if (material.Get(key, type, index, value) != aiReturn_SUCCESS || !(value >= 0.0f)) return -1.0f;
    return std::min(static_cast<float>(value), 1.0f);
}

/// A picture of numbers, whose places must be those of the colours.
uint32_t readMap(const aiMaterial& material, std::initializer_list<aiTextureType> types, TextureReader& textures,
                 unsigned channel)
{
    for (const aiTextureType type : types) {
        aiString name;
        unsigned own = 0;
        if (material.GetTexture(type, 0, &name, nullptr, &own) == aiReturn_SUCCESS && name.length > 0 && own == channel)
            return textures.read(name.C_Str());
    }
    return NO_INDEX;
}

void readMaps(const aiMaterial& material, TextureReader& textures, unsigned channel, SkinMaterial& converted)
{
    converted.normals = readMap(material, {aiTextureType_NORMALS}, textures, channel);
    // Assimp's words for glTF's picture of both, in its versions.
    converted.roughnesses = readMap(material, {aiTextureType_DIFFUSE_ROUGHNESS, aiTextureType_UNKNOWN}, textures,
                                    channel);
    ai_real scale = 1.0f;
    if (material.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), scale) == aiReturn_SUCCESS &&
        std::isfinite(scale))
        converted.normalScale = std::clamp(static_cast<float>(scale), 0.0f, 10.0f);
}

/// @param picture gets where the picture's places are.
SkinMaterial convertMaterial(const aiMaterial& material, TextureReader& textures, ConvertedMaterial& picture)
{
    SkinMaterial converted;
    aiString materialName;
    if (material.Get(AI_MATKEY_NAME, materialName) == aiReturn_SUCCESS) converted.name = materialName.C_Str();
    const MaterialColor color = colorOf(material);
    converted.color = color.rgb;
    converted.twoSided = isTwoSided(material);
    converted.alphaCutoff = alphaCutoffOf(material);
    converted.roughness = factorOf(material, AI_MATKEY_ROUGHNESS_FACTOR);
    converted.metalness = factorOf(material, AI_MATKEY_METALLIC_FACTOR);
    const auto wanted = color.isGlow ? std::array{aiTextureType_EMISSIVE, aiTextureType_EMISSION_COLOR}
                                     : std::array{aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
    for (const aiTextureType type : wanted) {
        aiString name;
        unsigned channel = 0;
        aiTextureMapMode modes[] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
        if (material.GetTexture(type, 0, &name, nullptr, &channel, nullptr, nullptr, modes) != aiReturn_SUCCESS ||
            name.length == 0)
            continue;
        converted.texture = textures.read(name.C_Str());
        converted.wrap = {wrapOf(modes[0]), wrapOf(modes[1])};
        picture.uvChannel = channel;
        aiUVTransform transform;
        if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), transform) == aiReturn_SUCCESS)
            picture.moved = movedBy(transform);
        if (isCutOut(material, name)) converted.alphaCutoff = BLENDED_CUTOFF;
        break;
    }
    converted.alphaCutoff = cutoffOf(converted, color.alpha);
    readMaps(material, textures, picture.uvChannel, converted);
    return converted;
}

}  // namespace

std::vector<ConvertedMaterial> convertMaterials(const aiScene& scene, const NodeTable& table, const std::string& path,
                                                Model& model)
{
    TextureReader textures(scene, path, model);
    std::vector<ConvertedMaterial> converted(std::max(scene.mNumMaterials, 1u));
    std::set<const aiMesh*> taken;
    forEachMesh(scene, table, [&](const aiMesh& mesh, uint32_t) { taken.insert(&mesh); });
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
        if ((table.isPicked || !table.apart.empty()) && !taken.contains(scene.mMeshes[i])) continue;
        const unsigned m = scene.mMeshes[i]->mMaterialIndex;
        ConvertedMaterial& entry = converted.at(m);
        if (entry.index != NO_INDEX) continue;
        entry.index = static_cast<uint32_t>(model.surface.materials.size());
        model.surface.materials.push_back(
            m < scene.mNumMaterials ? convertMaterial(*scene.mMaterials[m], textures, entry) : SkinMaterial());
    }
    return converted;
}

}  // namespace knuckle
