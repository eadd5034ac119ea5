#include "render/picture/image.h"

#include <fmt/format.h>
#include <libdeflate.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

// Not declared in stb's header, but meant to be called: the encoder inside stbi_write_png.
extern "C" unsigned char* stbi_write_png_to_mem(const unsigned char* pixels, int strideBytes, int width, int height,
                                                int channels, int* byteCount);

namespace knuckle {

extern thread_local int deflateLevel;

namespace {

constexpr int QUICK_LEVEL = 1, SMALL_LEVEL = 12;

constexpr int CHANNELS = 3;
/// PNG's "up" filter for every row: spheres repeat downwards as well as sideways, and a fixed filter saves trying all.
constexpr int UP_FILTER = 2;

/// Big-endian, as all numbers of a PNG.
std::string pngNumber(uint32_t number)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
    return bytes;
}

/// An iTXt chunk, uncompressed, without a language.
std::string textChunk(const std::string& keyword, const std::string& text)
{
    const std::string body = keyword + std::string(5, '\0') + text, checked = "iTXt" + body;
    return pngNumber(static_cast<uint32_t>(body.size())) + checked +
           pngNumber(libdeflate_crc32(0, checked.data(), checked.size()));
}

/// Four bytes a pixel.
std::vector<uint8_t> withAlpha(const Image& image)
{
    std::vector<uint8_t> pixels;
    for (size_t i = 0; i < image.alpha.size(); ++i) {
        const auto color = image.rgb.begin() + static_cast<std::ptrdiff_t>(CHANNELS * i);
        pixels.insert(pixels.end(), color, color + CHANNELS);
        pixels.push_back(image.alpha[i]);
    }
    return pixels;
}

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

template <typename Channel>
struct Decoded {
    uint32_t width = 0, height = 0;
    std::unique_ptr<Channel, Free> pixels;
    size_t pixelCount() const { return static_cast<size_t>(width) * height; }
};

/// @param load one of stb's loaders, with the file, pointers to width, height and channels, and the wanted channels.
template <typename Channel, typename Load>
Decoded<Channel> decodeFile(const std::string& path, Load load, int wanted)
{
    std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw InputError(fmt::format("image {} cannot be opened: {}", path, std::strerror(errno)));
    int width = 0, height = 0, channels = 0;
    std::unique_ptr<Channel, Free> pixels(load(file.get(), &width, &height, &channels, wanted));
    if (!pixels)
        throw InputError(
            fmt::format("image {} cannot be read: {}; PNG and JPEG are known", path, stbi_failure_reason()));
    return {static_cast<uint32_t>(width), static_cast<uint32_t>(height), std::move(pixels)};
}

}  // namespace

Image readImage(const std::string& path)
{
    const auto decoded = decodeFile<stbi_uc>(path, stbi_load_from_file, CHANNELS);
    Image image{decoded.width, decoded.height, {}};
    image.rgb.assign(decoded.pixels.get(), decoded.pixels.get() + decoded.pixelCount() * CHANNELS);
    return image;
}

GreyImage readGreyImage(const std::string& path)
{
    // stb extends 8 bits to 16 by repeating them, so that white is 65535 in both cases.
    const auto decoded = decodeFile<stbi_us>(path, stbi_load_from_file_16, 1);
    GreyImage image{decoded.width, decoded.height, {}};
    for (size_t i = 0; i < decoded.pixelCount(); ++i)
        image.values.push_back(static_cast<float>(decoded.pixels.get()[i]) / 65535.0f);
    return image;
}

std::string encodePng(uint32_t width, uint32_t height, uint32_t channels, std::span<const uint8_t> pixels)
{
    stbi_write_force_png_filter = UP_FILTER;
    const int columns = static_cast<int>(width), parts = static_cast<int>(channels);
    int byteCount = 0;
    const std::unique_ptr<unsigned char, Free> bytes(
        stbi_write_png_to_mem(pixels.data(), columns * parts, columns, static_cast<int>(height), parts, &byteCount));
    if (!bytes || byteCount <= 0) throw RunError("a picture cannot be encoded: out of memory");
    return {reinterpret_cast<const char*>(bytes.get()), static_cast<size_t>(byteCount)};
}

std::string pngOf(const Image& image, PngEffort effort)
{
    deflateLevel = effort == PngEffort::Small ? SMALL_LEVEL : QUICK_LEVEL;
    const bool opaque = image.alpha.empty();
    std::string png = encodePng(image.width, image.height, opaque ? CHANNELS : CHANNELS + 1,
                                opaque ? image.rgb : withAlpha(image)),
                chunks;
    deflateLevel = QUICK_LEVEL;
    for (const auto& [keyword, text] : image.text) chunks += textChunk(keyword, text);
    // After the signature and the header, which are of fixed length.
    constexpr size_t HEADER_END = 8 + 25;
    return png.insert(HEADER_END, chunks);
}

std::string jpegOf(const Image& image, int quality)
{
    std::string bytes;
    const auto add = [](void* context, void* data, int size) {
        static_cast<std::string*>(context)->append(static_cast<const char*>(data), static_cast<size_t>(size));
    };
    if (stbi_write_jpg_to_func(add, &bytes, static_cast<int>(image.width), static_cast<int>(image.height), CHANNELS,
                               image.rgb.data(), quality) == 0)
        throw RunError("a picture cannot be encoded: out of memory");
    return bytes;
}

void writePng(const std::string& path, const Image& image)
{
    writeFile(path, pngOf(image));
}

}  // namespace knuckle
