#include "render/overlay/font.h"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "sim/base/errors.h"
#include "sim/base/utf8.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wcast-align"
#pragma GCC diagnostic ignored "-Wold-style-cast"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace knuckle {

struct Font::File {
    std::string bytes;
    stbtt_fontinfo info{};

    float scale(int size) const { return stbtt_ScaleForPixelHeight(&info, static_cast<float>(size)); }
};

Font::Font(const std::string& path) : file_(std::make_unique<File>())
{
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError(fmt::format(
            "font {} cannot be read, and the picture has text; install it (apt install fonts-dejavu-core)", path));
    file_->bytes.assign(std::istreambuf_iterator<char>(in), {});
    const auto* data = reinterpret_cast<const unsigned char*>(file_->bytes.data());
    const int start = file_->bytes.size() < 12 ? -1 : stbtt_GetFontOffsetForIndex(data, 0);
    if (start < 0 || stbtt_InitFont(&file_->info, data, start) == 0)
        throw InputError(
            fmt::format("font {} is no TrueType font; install it anew (apt install fonts-dejavu-core)", path));
}

Font::~Font() = default;

const Glyph& Font::glyph(uint32_t codePoint, int size)
{
    const auto [found, isNew] = glyphs_.try_emplace({codePoint, size});
    Glyph& glyph = found->second;
    if (!isNew) return glyph;
    const float scale = file_->scale(size);
    const int point = static_cast<int>(codePoint);
    int right = 0, bottom = 0;
    stbtt_GetCodepointBitmapBox(&file_->info, point, scale, scale, &glyph.left, &glyph.top, &right, &bottom);
    glyph.width = right - glyph.left;
    glyph.height = bottom - glyph.top;
    glyph.ink.resize(static_cast<size_t>(glyph.width) * static_cast<size_t>(glyph.height));
    if (!glyph.ink.empty())
        stbtt_MakeCodepointBitmap(&file_->info, glyph.ink.data(), glyph.width, glyph.height, glyph.width, scale, scale,
                                  point);
    return glyph;
}

float Font::advance(uint32_t codePoint, uint32_t next, int size) const
{
    int wide = 0, bearing = 0;
    const int point = static_cast<int>(codePoint);
    stbtt_GetCodepointHMetrics(&file_->info, point, &wide, &bearing);
    const int kern = next == 0 ? 0 : stbtt_GetCodepointKernAdvance(&file_->info, point, static_cast<int>(next));
    return file_->scale(size) * static_cast<float>(wide + kern);
}

float Font::width(std::string_view text, int size) const
{
    const std::vector<uint32_t> points = codePointsOf(text);
    float width = 0.0f;
    for (size_t i = 0; i < points.size(); ++i)
        width += advance(points[i], i + 1 < points.size() ? points[i + 1] : 0, size);
    return width;
}

float Font::ascent(int size) const
{
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&file_->info, &ascent, &descent, &gap);
    return file_->scale(size) * static_cast<float>(ascent);
}

}  // namespace knuckle
