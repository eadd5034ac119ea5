#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// Text as UTF-8: invalid bytes are taken for Latin-1.
std::string validText(std::string_view text);

}  // namespace knuckle
