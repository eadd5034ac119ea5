#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// CRC-32 and size, in hexadecimal digits with a dash between.
std::string checksumOf(std::string_view bytes);
/// The same of a file. @throws InputError if it cannot be read.
std::string fileChecksum(const std::string& path);

}  // namespace knuckle
