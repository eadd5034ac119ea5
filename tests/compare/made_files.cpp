#include "tests/compare/made_files.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfTiledOutputFile.h>
#include <png.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>

#include <jpeglib.h>

namespace knuckle::test {

namespace {

void append(png_structp png, png_bytep bytes, size_t count)
{
    static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), count);
}

void flush(png_structp) {}

void writeColors(png_structp png, png_infop info, const PngMade& made)
{
    if (!made.palette.empty()) {
        std::vector<png_color> colors;
        for (const auto& color : made.palette) colors.push_back({color[0], color[1], color[2]});
        png_set_PLTE(png, info, colors.data(), static_cast<int>(colors.size()));
    }
    if (!made.paletteAlpha.empty())
        png_set_tRNS(png, info, made.paletteAlpha.data(), static_cast<int>(made.paletteAlpha.size()), nullptr);
    if (made.clearGrey >= 0) {
        png_color_16 color = {};
        color.gray = static_cast<uint16_t>(made.clearGrey);
        png_set_tRNS(png, info, nullptr, 0, &color);
    }
    png_set_benign_errors(png, 1);  // sRGB beside another gamma is only told
    if (made.srgb) png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    if (made.gamma > 0.0) png_set_gAMA(png, info, made.gamma);
}

void writeText(png_structp png, png_infop info, const PngMade& made)
{
    const auto write = [&](const std::pair<std::string, std::string>& entry, int kind) {
        std::string key = entry.first, value = entry.second, none;
        png_text text = {};
        text.compression = kind;
        text.key = key.data();
        text.text = value.data();
        text.lang = text.lang_key = none.data();
        png_set_text(png, info, &text, 1);
    };
    for (const auto& entry : made.latinText) write(entry, PNG_TEXT_COMPRESSION_NONE);
    for (const auto& entry : made.unicodeText) write(entry, PNG_ITXT_COMPRESSION_NONE);
}

/// Collects what OpenEXR writes.
class BytesOut : public Imf::OStream {
public:
    BytesOut() : Imf::OStream("made") {}
    void write(const char bytes[], int count) override
    {
        const auto size = static_cast<size_t>(count);
        if (at_ + size > bytes_.size()) bytes_.resize(at_ + size);
        std::memcpy(bytes_.data() + at_, bytes, size);
        at_ += size;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t at) override { at_ = at; }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    size_t at_ = 0;
};

}  // namespace

std::string pngBytes(const PngMade& made)
{
    std::string bytes;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &bytes, append, flush);
    png_set_IHDR(png, info, made.width, made.height, made.bits, made.type,
                 made.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
                 PNG_FILTER_TYPE_DEFAULT);
    writeColors(png, info, made);
    writeText(png, info, made);
    std::vector<std::vector<uint8_t>> rows = made.rows;
    std::vector<png_bytep> pointers;
    for (std::vector<uint8_t>& row : rows) pointers.push_back(row.data());
    png_write_info(png, info);
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return bytes;
}

PngMade anyRgb(uint32_t width, uint32_t height)
{
    PngMade made;
    made.width = width;
    made.height = height;
    for (uint32_t y = 0; y < height; ++y) {
        std::vector<uint8_t> row;
        for (uint32_t x = 0; x < width; ++x)
            for (const uint32_t value : {x * 7 + y, y * 5 + 40, x + y * 3 + 90})
                row.push_back(static_cast<uint8_t>(value));
        made.rows.push_back(row);
    }
    return made;
}

std::string jpegBytes(uint32_t width, uint32_t height, int parts, const std::vector<uint8_t>& samples)
{
    jpeg_compress_struct codec = {};
    jpeg_error_mgr errors = {};
    codec.err = jpeg_std_error(&errors);
    jpeg_create_compress(&codec);
    unsigned char* memory = nullptr;
    unsigned long size = 0;
    jpeg_mem_dest(&codec, &memory, &size);
    codec.image_width = width;
    codec.image_height = height;
    codec.input_components = parts;
    codec.in_color_space = parts == 1 ? JCS_GRAYSCALE : JCS_RGB;
    jpeg_set_defaults(&codec);
    jpeg_set_quality(&codec, 95, TRUE);
    jpeg_start_compress(&codec, TRUE);
    for (uint32_t y = 0; y < height; ++y) {
        std::vector<uint8_t> row(samples.begin() + y * width * static_cast<uint32_t>(parts),
                                 samples.begin() + (y + 1) * width * static_cast<uint32_t>(parts));
        JSAMPROW pointer = row.data();
        jpeg_write_scanlines(&codec, &pointer, 1);
    }
    jpeg_finish_compress(&codec);
    jpeg_destroy_compress(&codec);
    std::string bytes(reinterpret_cast<const char*>(memory), size);
    std::free(memory);
    return bytes;
}

std::string exrBytes(const ExrMade& made)
{
    const Imath::Box2i data({made.left, made.top}, {made.left + made.width - 1, made.top + made.height - 1});
    const Imath::Box2i shown = made.shownWidth > 0 ? Imath::Box2i({0, 0}, {made.shownWidth - 1, made.shownHeight - 1})
                                                   : data;
    Imf::Header header(shown, data);
    header.compression() = Imf::ZIP_COMPRESSION;
    if (made.tiled) header.setTileDescription(Imf::TileDescription(16, 16, Imf::ONE_LEVEL));
    Imf::FrameBuffer frame;
    std::vector<std::vector<Imath::half>> halves;
    halves.reserve(made.channels.size());
    const auto insert = [&](const std::string& name, Imf::PixelType type, const char* first, size_t size) {
        const auto stride = static_cast<ptrdiff_t>(size), row = stride * made.width;
        frame.insert(name, Imf::Slice(type, const_cast<char*>(first) - made.left * stride - made.top * row, size,
                                      static_cast<size_t>(row)));
        header.channels().insert(name, Imf::Channel(type));
    };
    for (const auto& [name, values] : made.channels) {
        if (made.half) {
            halves.emplace_back(values.begin(), values.end());
            insert(name, Imf::HALF, reinterpret_cast<const char*>(halves.back().data()), sizeof(Imath::half));
        } else {
            insert(name, Imf::FLOAT, reinterpret_cast<const char*>(values.data()), sizeof(float));
        }
    }
    BytesOut out;
    if (made.tiled) {
        Imf::TiledOutputFile file(out, header);
        file.setFrameBuffer(frame);
        file.writeTiles(0, file.numXTiles() - 1, 0, file.numYTiles() - 1);
    } else {
        Imf::OutputFile file(out, header);
        file.setFrameBuffer(frame);
        file.writePixels(made.height);
    }
    return out.bytes();
}

}  // namespace knuckle::test
