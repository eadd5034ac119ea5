#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// Text as UTF-8: what is none of it is taken for Latin-1, byte by byte.
std::string validText(std::string_view text);

}  // namespace knuckle
