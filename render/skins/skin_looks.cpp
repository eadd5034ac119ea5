#include "render/skins/skin_looks.h"

#include "render/color_word.h"
#include "shared/draw_types.h"

namespace knuckle {

namespace {

uint32_t packNumbers(const uint8_t* rgba)
{
    return rgba[0] | uint32_t{rgba[1]} << 8 | uint32_t{rgba[2]} << 16 | uint32_t{rgba[3]} << 24;
}

}  // namespace

SkinLooks::Range SkinLooks::addPicture(const SkinMesh& mesh, uint32_t index, bool isColor)
{
    if (index == NO_INDEX) return {0.0f, 0.0f};
    const auto [entry, isNew] = added_.try_emplace({index, isColor});
    if (!isNew) return entry->second;
    const size_t first = levels.size();
    TexturePicture picture = mesh.textures[index];
    for (bool isLast = false; !isLast;) {
        levels.push_back({picture.width, picture.height, static_cast<uint32_t>(texels.size()), 0});
        for (size_t i = 0; i < picture.rgba.size(); i += 4)
            texels.push_back(isColor ? packPixel(&picture.rgba[i]) : packNumbers(&picture.rgba[i]));
        isLast = picture.width == 1 && picture.height == 1;
        picture = halved(picture, isColor);
    }
    return entry->second = {static_cast<float>(first), static_cast<float>(levels.size() - first)};
}

uint32_t SkinLooks::add(const SkinMesh& mesh)
{
    added_.clear();
    const auto first = static_cast<uint32_t>(materials.size() / SKIN_MATERIAL_TEXELS);
    for (const SkinMaterial& material : mesh.materials) {
        const auto [level, count] = addPicture(mesh, material.texture, true);
        const auto [normals, normalCount] = addPicture(mesh, material.normals, false);
        const auto [roughs, roughCount] = addPicture(mesh, material.roughnesses, false);
        const int sides = (material.twoSided ? 1 : 0) | int(material.wrap[0]) << 1 | int(material.wrap[1]) << 3;
        const auto factor = [](float given) { return given < 0.0f ? 1.0f : given; };
        materials.push_back({material.alphaCutoff, static_cast<float>(sides), level, count});
        materials.push_back({normals, normalCount, material.normalScale, 0.0f});
        materials.push_back({roughs, roughCount, factor(material.roughness), factor(material.metalness)});
    }
    return first;
}

}  // namespace knuckle
