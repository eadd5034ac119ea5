// jpeglib.h needs FILE and size_t before it.
#include <cstdio>

#include <fmt/format.h>
#include <jerror.h>
#include <jpeglib.h>

#include <array>
#include <csetjmp>

#include "render/reader/decoders.h"

namespace knuckle {

namespace {

/// Everything lives here and not in functions that libjpeg's errors jump out of.
struct JpegFile {
    jpeg_error_mgr errors = {};  ///< First, so that a pointer to it is one to all.
    jpeg_decompress_struct codec = {};
    std::jmp_buf jump = {};
    std::array<char, JMSG_LENGTH_MAX> message = {};
    bool damaged = false;
    std::vector<JSAMPLE> pixels;
    size_t rowSize = 0;
    std::string comment;

    ~JpegFile() { jpeg_destroy_decompress(&codec); }
};

JpegFile& fileOf(j_common_ptr codec)
{
    return *reinterpret_cast<JpegFile*>(codec->err);
}

void leave(j_common_ptr codec)
{
    JpegFile& file = fileOf(codec);
    codec->err->format_message(codec, file.message.data());
    std::longjmp(file.jump, 1);
}

/// Warnings have a negative level. Some are of harmless bytes that should not be there; the others mean that pixels are
/// missing or made up.
void noteMessage(j_common_ptr codec, int level)
{
    if (level >= 0) return;
    const int code = codec->err->msg_code;
    if (code == JWRN_EXTRANEOUS_DATA || code == JWRN_ADOBE_XFORM || code == JWRN_JFIF_MAJOR) return;
    fileOf(codec).damaged = true;
    leave(codec);
}

void printNothing(j_common_ptr) {}

bool readHeader(JpegFile& file, std::string_view bytes)
{
    if (setjmp(file.jump)) return false;
    jpeg_create_decompress(&file.codec);
    jpeg_mem_src(&file.codec, reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
    jpeg_save_markers(&file.codec, JPEG_COM, 0xffff);
    jpeg_read_header(&file.codec, TRUE);
    return true;
}

bool readPixels(JpegFile& file)
{
    if (setjmp(file.jump)) return false;
    jpeg_decompress_struct& codec = file.codec;
    if (codec.jpeg_color_space == JCS_YCbCr || codec.jpeg_color_space == JCS_GRAYSCALE) codec.out_color_space = JCS_RGB;
    else if (codec.num_components == 4) codec.out_color_space = JCS_CMYK;
    jpeg_start_decompress(&codec);
    file.rowSize = static_cast<size_t>(codec.output_width) * static_cast<size_t>(codec.output_components);
    file.pixels.resize(file.rowSize * codec.output_height);
    while (codec.output_scanline < codec.output_height) {
        JSAMPROW row = file.pixels.data() + codec.output_scanline * file.rowSize;
        jpeg_read_scanlines(&codec, &row, 1);
    }
    if (codec.marker_list != nullptr)
        file.comment.assign(reinterpret_cast<const char*>(codec.marker_list->data), codec.marker_list->data_length);
    jpeg_finish_decompress(&codec);
    return true;
}

void takePixels(const JpegFile& file, Picture& picture)
{
    const auto parts = static_cast<size_t>(file.codec.output_components);
    picture.rgba.reserve(picture.pixelCount() * 4);
    // Programs that write CMYK (Adobe's) store how much light is left, not how much ink is laid.
    const bool inverted = file.codec.saw_Adobe_marker != FALSE;
    const auto light = [&](size_t i) {
        const float value = static_cast<float>(file.pixels[i]) / 255.0f;
        return parts == 4 && !inverted ? 1.0f - value : value;
    };
    for (size_t i = 0; i < file.pixels.size(); i += parts) {
        const float black = parts == 4 ? light(i + 3) : 1.0f;
        for (size_t c = 0; c < 3; ++c) picture.rgba.push_back(light(parts == 1 ? i : i + c) * black);
        picture.rgba.push_back(1.0f);
    }
}

[[noreturn]] void fail(const JpegFile& file, const std::string& name)
{
    failPicture(name, fmt::format("{}; {}write it anew", file.message.data(),
                                  file.damaged ? "the file is cut or damaged, " : ""));
}

}  // namespace

Picture decodeJpeg(std::string_view bytes, const std::string& name)
{
    JpegFile file;
    file.codec.err = jpeg_std_error(&file.errors);
    file.errors.error_exit = leave;
    file.errors.emit_message = noteMessage;
    file.errors.output_message = printNothing;
    if (!readHeader(file, bytes)) fail(file, name);
    checkPictureSize(file.codec.image_width, file.codec.image_height, name);
    if (!readPixels(file)) fail(file, name);
    Picture picture;
    picture.width = file.codec.output_width;
    picture.height = file.codec.output_height;
    takePixels(file, picture);
    if (!file.comment.empty()) picture.text["comment"] = utf8OfLatin1(file.comment);
    return picture;
}

}  // namespace knuckle
