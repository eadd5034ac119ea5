#pragma once

#include <string>

namespace knuckle {

/// CRC-32 and size of a file, in hexadecimal digits with a dash between. @throws InputError if it cannot be read.
std::string fileChecksum(const std::string& path);

}  // namespace knuckle
