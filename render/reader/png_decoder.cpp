#include <fmt/format.h>
#include <png.h>

#include <array>
#include <cmath>
#include <csetjmp>
#include <cstring>

#include "render/reader/decoders.h"

namespace knuckle {

namespace {

constexpr size_t CHANNELS = 4;
/// What files say that mean sRGB, for programs that know only gamma.
constexpr double SRGB_GAMMA = 1.0 / 2.2;

/// Everything lives here and not in functions that libpng's errors jump out of.
struct PngFile {
    std::string_view bytes;
    size_t at = 0;
    png_structp png = nullptr;
    png_infop info = nullptr;
    std::string error;
    uint32_t width = 0, height = 0, depth = 0;
    bool hasAlpha = false;
    double gamma = 0.0;  ///< Of the file, where it counts; 0: sRGB.
    std::vector<png_byte> pixels;
    std::vector<png_bytep> rows;

    ~PngFile() { png_destroy_read_struct(&png, &info, nullptr); }
};

void noteError(png_structp png, png_const_charp message)
{
    static_cast<PngFile*>(png_get_error_ptr(png))->error = message;
    png_longjmp(png, 1);
}

void ignoreWarning(png_structp, png_const_charp) {}

void takeBytes(png_structp png, png_bytep out, size_t count)
{
    auto& file = *static_cast<PngFile*>(png_get_io_ptr(png));
    if (count > file.bytes.size() - file.at) png_error(png, "it ends too early");
    std::memcpy(out, file.bytes.data() + file.at, count);
    file.at += count;
}

bool readHeader(PngFile& file)
{
    if (setjmp(png_jmpbuf(file.png))) return false;
    png_set_crc_action(file.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_read_fn(file.png, &file, takeBytes);
    png_read_info(file.png, file.info);
    file.width = png_get_image_width(file.png, file.info);
    file.height = png_get_image_height(file.png, file.info);
    file.depth = png_get_bit_depth(file.png, file.info);
    file.hasAlpha = (png_get_color_type(file.png, file.info) & PNG_COLOR_MASK_ALPHA) != 0 ||
                    png_get_valid(file.png, file.info, PNG_INFO_tRNS) != 0;
    // sRGB and a colour profile come before gAMA, which is left for files that have nothing better to say.
    const bool better = png_get_valid(file.png, file.info, PNG_INFO_sRGB) != 0 ||
                        png_get_valid(file.png, file.info, PNG_INFO_iCCP) != 0;
    if (!better && png_get_valid(file.png, file.info, PNG_INFO_gAMA) != 0)
        png_get_gAMA(file.png, file.info, &file.gamma);
    return true;
}

bool readPixels(PngFile& file)
{
    if (setjmp(png_jmpbuf(file.png))) return false;
    png_set_expand(file.png);
    png_set_gray_to_rgb(file.png);
    png_set_add_alpha(file.png, 0xffff, PNG_FILLER_AFTER);
    png_set_interlace_handling(file.png);
    png_read_update_info(file.png, file.info);
    const size_t rowBytes = png_get_rowbytes(file.png, file.info);
    file.pixels.resize(rowBytes * file.height);
    file.rows.resize(file.height);
    for (uint32_t y = 0; y < file.height; ++y) file.rows[y] = file.pixels.data() + y * rowBytes;
    png_read_image(file.png, file.rows.data());
    png_read_end(file.png, file.info);
    return true;
}

/// A lookup table: what each value of a channel is in sRGB.
std::vector<float> encodedValues(uint32_t depth, double gamma)
{
    std::vector<float> values(depth == 16 ? 65536 : 256);
    const bool convert = gamma > 0.0 && std::fabs(gamma - SRGB_GAMMA) > 5e-4;
    for (size_t i = 0; i < values.size(); ++i) {
        const double value = static_cast<double>(i) / static_cast<double>(values.size() - 1);
        values[i] = static_cast<float>(value);
        if (convert) values[i] = encodeSrgb(static_cast<float>(std::pow(value, 1.0 / gamma)));
    }
    return values;
}

void takePixels(const PngFile& file, Picture& picture)
{
    picture.rgba.resize(picture.pixelCount() * CHANNELS);
    const bool wide = file.depth == 16;
    const std::vector<float> values = encodedValues(file.depth, file.gamma);
    const auto stored = [&](size_t i) {
        return wide ? static_cast<size_t>(file.pixels[2 * i]) << 8 | file.pixels[2 * i + 1] : file.pixels[i];
    };
    const float scale = 1.0f / static_cast<float>(values.size() - 1);
    for (size_t i = 0; i < picture.rgba.size(); i += CHANNELS) {
        const float alpha = static_cast<float>(stored(i + 3)) * scale;
        for (size_t c = 0; c < 3; ++c)
            picture.rgba[i + c] = file.hasAlpha ? values[stored(i + c)] * alpha : values[stored(i + c)];
        picture.rgba[i + 3] = alpha;
    }
}

void takeText(const PngFile& file, Picture& picture)
{
    png_textp texts = nullptr;
    const int count = png_get_text(file.png, file.info, &texts, nullptr);
    for (int i = 0; i < count; ++i) {
        const png_text& text = texts[i];
        const bool unicode = text.compression == PNG_ITXT_COMPRESSION_NONE ||
                             text.compression == PNG_ITXT_COMPRESSION_zTXt;
        const std::string value = text.text != nullptr ? text.text : "";
        picture.text[utf8OfLatin1(text.key)] = unicode ? value : utf8OfLatin1(value);
    }
}

/// libpng's words for what is wrong, with what they mean to the user.
std::string reasonOf(const PngFile& file)
{
    const bool damaged = file.error.find("CRC") != std::string::npos;
    return fmt::format("{}; {}", file.error.empty() ? "it is damaged" : file.error,
                       damaged ? "the file is damaged, write it anew" : "write it anew");
}

}  // namespace

Picture decodePng(std::string_view bytes, const std::string& name)
{
    PngFile file;
    file.bytes = bytes;
    file.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &file, noteError, ignoreWarning);
    file.info = file.png != nullptr ? png_create_info_struct(file.png) : nullptr;
    if (file.info == nullptr) failPicture(name, "there is no memory for it");
    if (!readHeader(file)) failPicture(name, reasonOf(file));
    checkPictureSize(file.width, file.height, name);
    if (!readPixels(file)) failPicture(name, reasonOf(file));
    Picture picture;
    picture.width = file.width;
    picture.height = file.height;
    picture.bitDepth = file.depth;
    picture.hasAlpha = file.hasAlpha;
    takePixels(file, picture);
    takeText(file, picture);
    return picture;
}

}  // namespace knuckle
