#pragma once

#include <string>
#include <string_view>

#include "render/reader/picture.h"

namespace knuckle {

/// What decodePicture() hands on, one function for each format. @throws InputError.
Picture decodePng(std::string_view bytes, const std::string& name);
Picture decodeJpeg(std::string_view bytes, const std::string& name);
Picture decodeExr(std::string_view bytes, const std::string& name);

/// Refuses sizes that no memory would do for. @throws InputError.
void checkPictureSize(uint64_t width, uint64_t height, const std::string& name);
[[noreturn]] void failPicture(const std::string& name, const std::string& reason);
/// @param text of the Latin-1 encoding.
std::string utf8OfLatin1(std::string_view text);

}  // namespace knuckle
