// stb's decoder for textures, for this file only: frames (render/picture) use another one with other settings.
#include "sim/rig/import/assimp/looks/texture_decoder.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STBI_NO_GIF
#define STBI_NO_HDR
#define STBI_NO_PIC
#define STBI_NO_PNM
#define STBI_NO_LINEAR
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

#include <webp/decode.h>

#include <algorithm>

namespace knuckle {

namespace {

bool isSizeRead(int width, int height)
{
    return width >= 1 && height >= 1 && std::max(width, height) <= DECODED_SIDE;
}

/// Nothing for bytes that are not WebP, or damaged. Animations give no picture.
std::optional<TexturePicture> decodeWebp(std::span<const uint8_t> bytes)
{
    int width = 0, height = 0;
    if (!WebPGetInfo(bytes.data(), bytes.size(), &width, &height) || !isSizeRead(width, height)) return {};
    TexturePicture picture{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    picture.rgba.resize(size_t{4} * picture.width * picture.height);
    if (WebPDecodeRGBAInto(bytes.data(), bytes.size(), picture.rgba.data(), picture.rgba.size(), 4 * width) == nullptr)
        return {};
    return picture;
}

}  // namespace

std::optional<TexturePicture> decodeTexture(std::span<const uint8_t> bytes)
{
    if (std::optional<TexturePicture> picture = decodeWebp(bytes)) return picture;
    constexpr int CHANNELS = 4;
    const int size = static_cast<int>(std::min<size_t>(bytes.size(), INT32_MAX));
    int width = 0, height = 0, channels = 0;
    if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels)) return {};
    if (!isSizeRead(width, height)) return {};
    uint8_t* pixels = stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, CHANNELS);
    if (pixels == nullptr) return {};
    TexturePicture picture{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    picture.rgba.assign(pixels, pixels + size_t{CHANNELS} * picture.width * picture.height);
    stbi_image_free(pixels);
    return picture;
}

}  // namespace knuckle
