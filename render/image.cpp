#include "render/image.h"

#include <fmt/format.h>
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include "render/temporary_file.h"
#include "sim/world/errors.h"

// Not declared in stb's header, but meant to be called: the encoder behind stbi_write_png.
extern "C" unsigned char* stbi_write_png_to_mem(const unsigned char* pixels, int strideBytes, int width, int height,
                                                int channels, int* byteCount);

namespace knuckle {

namespace {

constexpr int CHANNELS = 3;
/// PNG's "up" filter for every row: spheres repeat downwards as well as sideways, and a fixed filter saves trying all.
constexpr int UP_FILTER = 2;
/// Differences are small: without a factor their picture is black.
constexpr int DIFFERENCE_GAIN = 8;

struct Free {
    void operator()(void* memory) const { std::free(memory); }
};

}  // namespace

Image readImage(const std::string& path)
{
    std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file) throw InputError(fmt::format("image {} cannot be opened: {}", path, std::strerror(errno)));
    int width = 0, height = 0, channels = 0;
    std::unique_ptr<stbi_uc, Free> pixels(stbi_load_from_file(file.get(), &width, &height, &channels, CHANNELS));
    if (!pixels)
        throw InputError(fmt::format("image {} cannot be read: {}; PNG and JPEG are known", path,
                                     stbi_failure_reason()));
    Image image{static_cast<uint32_t>(width), static_cast<uint32_t>(height), {}};
    image.rgb.assign(pixels.get(), pixels.get() + static_cast<size_t>(width) * static_cast<size_t>(height) * CHANNELS);
    return image;
}

void writePng(const std::string& path, const Image& image)
{
    stbi_write_force_png_filter = UP_FILTER;
    const int width = static_cast<int>(image.width);
    int byteCount = 0;
    const std::unique_ptr<unsigned char, Free> bytes(stbi_write_png_to_mem(
        image.rgb.data(), width * CHANNELS, width, static_cast<int>(image.height), CHANNELS, &byteCount));
    if (!bytes || byteCount <= 0) throw RunError(fmt::format("{} cannot be encoded: out of memory", path));
    TemporaryFile file(path);
    file.write(bytes.get(), static_cast<size_t>(byteCount));
    file.commit();
}

ImageDifference compareImages(const Image& a, const Image& b, uint32_t threshold)
{
    if (a.width != b.width || a.height != b.height)
        throw InputError(fmt::format("the images differ in size: {}x{} and {}x{}; render both at one --size", a.width,
                                     a.height, b.width, b.height));
    ImageDifference result;
    result.picture = {a.width, a.height, std::vector<uint8_t>(a.rgb.size())};
    uint64_t sum = 0, changed = 0;
    for (size_t pixel = 0; pixel < a.rgb.size(); pixel += CHANNELS) {
        uint32_t worst = 0;
        for (size_t i = pixel; i < pixel + CHANNELS; ++i) {
            const int difference = std::abs(int(a.rgb[i]) - int(b.rgb[i]));
            result.picture.rgb[i] = static_cast<uint8_t>(std::min(255, difference * DIFFERENCE_GAIN));
            sum += static_cast<uint64_t>(difference);
            worst = std::max(worst, static_cast<uint32_t>(difference));
        }
        result.worst = std::max(result.worst, worst);
        changed += worst > threshold ? 1 : 0;
    }
    if (!a.rgb.empty()) {
        result.meanAbsolute = static_cast<double>(sum) / static_cast<double>(a.rgb.size());
        result.changedShare = static_cast<double>(changed) * CHANNELS / static_cast<double>(a.rgb.size());
    }
    return result;
}

}  // namespace knuckle
