#include "render/skins/skin_looks.h"

#include "render/color_word.h"

namespace knuckle {

void SkinLooks::addPicture(TexturePicture picture)
{
    for (bool isLast = false; !isLast;) {
        levels.push_back({picture.width, picture.height, static_cast<uint32_t>(texels.size()), 0});
        for (size_t i = 0; i < picture.rgba.size(); i += 4) texels.push_back(packPixel(&picture.rgba[i]));
        isLast = picture.width == 1 && picture.height == 1;
        picture = halved(picture);
    }
}

uint32_t SkinLooks::add(const SkinMesh& mesh)
{
    std::vector<uint32_t> firstLevels;
    for (const TexturePicture& picture : mesh.textures) {
        firstLevels.push_back(static_cast<uint32_t>(levels.size()));
        addPicture(picture);
    }
    firstLevels.push_back(static_cast<uint32_t>(levels.size()));
    const auto first = static_cast<uint32_t>(materials.size());
    for (const SkinMaterial& material : mesh.materials) {
        const bool plain = material.texture == NO_INDEX;
        const uint32_t level = plain ? 0 : firstLevels[material.texture];
        const uint32_t count = plain ? 0 : firstLevels[material.texture + 1] - level;
        const int sides = (material.twoSided ? 1 : 0) | int(material.wrap[0]) << 1 | int(material.wrap[1]) << 3;
        materials.push_back(
            {material.alphaCutoff, static_cast<float>(sides), static_cast<float>(level), static_cast<float>(count)});
    }
    return first;
}

}  // namespace knuckle
