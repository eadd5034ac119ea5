#include "sim/world/matter/skin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sim/world/world.h"

namespace knuckle {

namespace {

void require(bool good, const char* what)
{
    if (!good) throw std::logic_error(fmt::format("skin: {}", what));
}

bool fits(const SkinMesh& mesh, const SkinVertex& vertex, uint32_t bodyCount)
{
    const auto known = [&](uint32_t body) { return body < bodyCount; };
    return vertex.material < mesh.materials.size() && std::ranges::all_of(vertex.bodies, known) &&
           vertex.position.allFinite() && vertex.normal.allFinite() && vertex.uv.allFinite();
}

}  // namespace

float wrapped(float place, TextureWrap wrap)
{
    if (wrap == TextureWrap::Clamp) return std::clamp(place, 0.0f, 1.0f);
    if (wrap == TextureWrap::Repeat) return place - std::floor(place);
    const float pair = 0.5f * place;
    return 1.0f - std::abs(2.0f * (pair - std::floor(pair)) - 1.0f);
}

TexturePicture halved(const TexturePicture& picture, bool isColor)
{
    TexturePicture half{std::max(1u, picture.width / 2), std::max(1u, picture.height / 2), {}};
    half.rgba.reserve(size_t{4} * half.width * half.height);
    for (uint32_t y = 0; y < half.height; ++y) {
        for (uint32_t x = 0; x < half.width; ++x) {
            for (uint32_t channel = 0; channel < 4; ++channel) {
                const bool isLight = isColor && channel < 3;
                float sum = 0.0f;
                for (const uint32_t corner : {0u, 1u, 2u, 3u}) {
                    const uint32_t column = std::min(2 * x + corner % 2, picture.width - 1);
                    const uint32_t row = std::min(2 * y + corner / 2, picture.height - 1);
                    const float value = picture.rgba[size_t{4} * (size_t{row} * picture.width + column) + channel];
                    // Averages squares of colours, which are nearly linear in light; all else is averaged as it is.
                    sum += isLight ? value * value : value;
                }
                const float mean = isLight ? std::sqrt(0.25f * sum) : 0.25f * sum;
                half.rgba.push_back(static_cast<uint8_t>(std::lround(mean)));
            }
        }
    }
    return half;
}

void validateSkins(const World& world)
{
    for (const Skin& skin : world.skins) {
        require(skin.mesh != nullptr, "has no mesh");
        const SkinMesh& mesh = *skin.mesh;
        for (const TexturePicture& picture : mesh.textures)
            require(picture.width > 0 && picture.height > 0 &&
                        std::max(picture.width, picture.height) <= TEXTURE_SIDE &&
                        picture.rgba.size() == size_t{4} * picture.width * picture.height,
                    "a texture is empty, too large, or has another size than it says");
        for (const SkinMaterial& material : mesh.materials)
            for (const uint32_t texture : {material.texture, material.normals, material.roughnesses})
                require(texture == NO_INDEX || texture < mesh.textures.size(),
                        "a material has a texture that is not there");
        for (const auto& triangle : mesh.triangles)
            require(*std::ranges::max_element(triangle) < mesh.vertices.size(), "a triangle has a vertex too many");
        for (const uint32_t object : skin.objects) {
            require(object < world.objects.size(), "an object that wears it is not there");
            const uint32_t bodies = world.objects[object].bodyCount;
            for (const SkinVertex& vertex : mesh.vertices)
                require(fits(mesh, vertex, bodies), "a vertex is not finite, or has a body or material too many");
        }
    }
}

}  // namespace knuckle
