#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "sim/base/no_index.h"

namespace knuckle {

/// Sides of texture pictures are 1 ... TEXTURE_SIDE pixels.
inline constexpr uint32_t TEXTURE_SIDE = 1024;

/// Rows from the top, four bytes a pixel: red, green, blue in sRGB, and alpha.
struct TexturePicture {
    uint32_t width = 0, height = 0;  ///< [pixels]
    std::vector<uint8_t> rgba;
};

/// The picture at half its sides, rounded down, at least one pixel: the next level of its mipmap.
/// @param isColor  Whether red, green and blue are colours, or other numbers.
TexturePicture halved(const TexturePicture& picture, bool isColor = true);

/// What continues a picture beyond its edge; TEXTURE_... of shaders/shared/constants.h.
enum class TextureWrap : uint8_t {
    Repeat,
    Mirror,  ///< The picture mirrored.
    Clamp,   ///< The pixels at the edge.
};

/// The place within the picture, 0 ... 1; both are fractions of its side.
float wrapped(float place, TextureWrap wrap);

/// Looks of a part of a mesh.
struct SkinMaterial {
    std::string name;
    Eigen::Vector3f color{0.8f, 0.8f, 0.8f};     ///< Linear RGB, 0-1; multiplied by the colours of texture and vertex.
    uint32_t texture = NO_INDEX;                 ///< Index of its picture, or none.
    bool twoSided = true;                        ///< Also seen from behind.
    float alphaCutoff = 0.0f;                    ///< Pixels with less alpha are not drawn, 0 ... 1.
    std::array<TextureWrap, 2> wrap{};           ///< Along u and v.
    float roughness = -1.0f, metalness = -1.0f;  ///< 0 ... 1; below 0: the model says nothing of it.
    uint32_t normals = NO_INDEX;      ///< Index of the picture of its normals, green upwards (glTF), or none.
    uint32_t roughnesses = NO_INDEX;  ///< The same of roughness (green) and metalness (blue), times the factors.
    float normalScale = 1.0f;         ///< Of their slopes, 0 ... 10.
};

/// Skinned to at most four bodies of an object.
struct SkinVertex {
    Eigen::Vector3f position{0, 0, 0};         ///< In the object's rest pose [m].
    Eigen::Vector3f normal{0, 1, 0};           ///< Unit.
    Eigen::Vector2f uv{0, 0};                  ///< 0, 0 is the upper left corner of the picture.
    Eigen::Vector3f color{1, 1, 1};            ///< Linear RGB, 0-1.
    uint32_t material = 0;                     ///< Index into SkinMesh::materials.
    std::array<uint32_t, 4> bodies{};          ///< Within the object.
    std::array<float, 4> weights{1, 0, 0, 0};  ///< Sum 1.
};

/// Triangles that move with the bodies of an object.
struct SkinMesh {
    std::vector<SkinVertex> vertices;
    std::vector<std::array<uint32_t, 3>> triangles;
    std::vector<SkinMaterial> materials;
    std::vector<TexturePicture> textures;
};

/// How a skin is drawn with its wearers' particles.
enum class SkinUse {
    Hide,   ///< The mesh is drawn instead of them.
    Cover,  ///< The mesh is drawn with them.
    Paint,  ///< They get its colours, and it is not drawn.
};

/// A mesh and the objects that wear it.
struct Skin {
    std::shared_ptr<const SkinMesh> mesh;
    std::vector<uint32_t> objects;  ///< Indices into World::objects.
    SkinUse use = SkinUse::Hide;
};

inline bool isDrawn(const Skin& skin)
{
    return skin.use != SkinUse::Paint;
}

struct World;

/// Validates skins. @throws std::logic_error.
void validateSkins(const World& world);

}  // namespace knuckle
