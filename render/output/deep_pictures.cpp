#include "render/output/deep_pictures.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <vector>

#include "render/output/exr_bytes.h"
#include "render/reader/picture.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

void add(std::string& bytes, uint32_t number, int size)
{
    for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
}

std::string chunk(const std::string& kind, const std::string& body)
{
    const std::string checked = kind + body;
    std::string bytes;
    add(bytes, static_cast<uint32_t>(body.size()), 4);
    bytes += checked;
    add(bytes, libdeflate_crc32(0, checked.data(), checked.size()), 4);
    return bytes;
}

/// Rows with PNG's "up" filter, as 8-bit frames have it.
std::string filteredRows(const Image& image)
{
    const bool opaque = image.alpha.empty();
    std::string rows, above, row;
    for (size_t y = 0; y < image.height; ++y) {
        row.clear();
        for (size_t pixel = y * image.width; pixel < (y + 1) * image.width; ++pixel) {
            for (size_t c = 0; c < 3; ++c) add(row, image.deep[3 * pixel + c], 2);
            if (!opaque) add(row, 257u * image.alpha[pixel], 2);
        }
        above.resize(row.size());
        rows += '\2';
        for (size_t k = 0; k < row.size(); ++k) rows += static_cast<char>(row[k] - above[k]);
        above = row;
    }
    return rows;
}

std::string packed(const std::string& bytes)
{
    libdeflate_compressor* compressor = libdeflate_alloc_compressor(1);
    if (compressor == nullptr) throw RunError("a picture cannot be encoded: out of memory");
    std::string out(libdeflate_zlib_compress_bound(compressor, bytes.size()), '\0');
    out.resize(libdeflate_zlib_compress(compressor, bytes.data(), bytes.size(), out.data(), out.size()));
    libdeflate_free_compressor(compressor);
    return out;
}

}  // namespace

std::string deepPngOf(const Image& image)
{
    std::string header, png{"\x89PNG\r\n\x1a\n", 8};
    add(header, image.width, 4);
    add(header, image.height, 4);
    header += {16, static_cast<char>(image.alpha.empty() ? 2 : 6), 0, 0, 0};
    png += chunk("IHDR", header);
    for (const auto& [keyword, text] : image.text) png += chunk("iTXt", keyword + std::string(5, '\0') + text);
    return png + chunk("IDAT", packed(filteredRows(image))) + chunk("IEND", "");
}

std::string exrOf(const Image& image)
{
    const size_t channels = image.alpha.empty() ? 3 : 4;
    constexpr std::array NAMES{"R", "G", "B", "A"};
    std::vector<Imath::half> pixels;
    pixels.reserve(channels * image.width * image.height);
    for (size_t i = 0; i < size_t{image.width} * image.height; ++i) {
        const float alpha = image.alpha.empty() ? 1.0f : static_cast<float>(image.alpha[i]) / 255.0f;
        for (size_t c = 0; c < 3; ++c)
            pixels.emplace_back(alpha * decodeSrgb(static_cast<float>(image.deep[3 * i + c]) / 65535.0f));
        if (channels == 4) pixels.emplace_back(alpha);
    }
    Imf::Header header(static_cast<int>(image.width), static_cast<int>(image.height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    const size_t stride = channels * sizeof(Imath::half);
    for (size_t c = 0; c < channels; ++c) {
        header.channels().insert(NAMES[c], Imf::Channel(Imf::HALF));
        frame.insert(NAMES[c],
                     Imf::Slice(Imf::HALF, reinterpret_cast<char*>(pixels.data() + c), stride, stride * image.width));
    }
    for (const auto& [keyword, text] : image.text) header.insert(keyword, Imf::StringAttribute(text));
    return exrBytes(header, frame);
}

}  // namespace knuckle
