#pragma once

#include <string>
#include <string_view>

#include "render/reader/picture.h"

namespace knuckle {

/// Pictures with more pixels are refused before memory is taken for them: 2^27, some 11,500 x 11,500.
constexpr uint64_t MAX_PICTURE_PIXELS = uint64_t{1} << 27;

/// The bytes of a file, a pipe or a device. @throws InputError for a folder, an empty file, one above 2 GiB, or one
/// that cannot be read.
std::string readPictureBytes(const std::string& path);

/// Decodes PNG, JPEG or OpenEXR, told apart by their content.
/// @param name for messages. @throws InputError of one line: another format, cut, damaged, too large.
Picture decodePicture(std::string_view bytes, const std::string& name);

/// Both.
Picture readPicture(const std::string& path);

}  // namespace knuckle
