#include "render/sky/sky_textures.h"

#include <algorithm>

#include "shared/draw_types.h"

namespace knuckle {

namespace {

/// Of maps of what rough surfaces mirror: texels of 5.6 degrees.
constexpr uint32_t BLUR_WIDTH = 64;
/// The largest number of half precision is 65504.
constexpr float BRIGHTEST = 60000.0f;

const SkyMap& blackUnless(const SkyMap* map)
{
    static const SkyMap BLACK{2, 1, {Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero()}};
    return map != nullptr ? *map : BLACK;
}

/// Three floats a texel, with a border: columns go on at the other side, rows as they are.
void addBordered(std::vector<float>& out, const SkyMap& map)
{
    for (uint32_t y = 0; y < map.height + 2; ++y) {
        const uint32_t row = std::clamp(y, 1u, map.height) - 1;
        for (uint32_t x = 0; x < map.width + 2; ++x) {
            const Eigen::Vector3f& light = map.at((x + map.width - 1) % map.width, row);
            for (int k = 0; k < 3; ++k) out.push_back(std::clamp(light[k], 0.0f, BRIGHTEST));
        }
    }
}

Texture textureOf(const char* label, uint32_t width, const std::vector<float>& texels)
{
    const auto height = static_cast<uint32_t>(texels.size() / 3 / width);
    Texture texture(label, GL_RGBA16F, width, height, GL_LINEAR);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, static_cast<GLsizei>(width), static_cast<GLsizei>(height), GL_RGB, GL_FLOAT,
                    texels.data());
    return texture;
}

}  // namespace

SkyTextures::SkyTextures(const SkyMap* map)
{
    const SkyMap& sky = blackUnless(map);
    std::vector<float> texels;
    addBordered(texels, sky);
    picture_ = textureOf("skyPicture", sky.width + 2, texels);
    texels.clear();
    for (uint32_t k = 1; k <= SKY_BLURS; ++k)
        addBordered(texels, map == nullptr ? sky : blurred(sky, static_cast<float>(k) / SKY_BLURS, BLUR_WIDTH));
    blurs_ = textureOf("skyBlurs", map == nullptr ? sky.width + 2 : BLUR_WIDTH + 2, texels);
}

}  // namespace knuckle
