#pragma once

#include <string>
#include <string_view>

namespace knuckle {

/// RFC 4648, with padding.
std::string toBase64(std::string_view bytes);
/// The inverse; skips what is no digit.
std::string fromBase64(std::string_view text);

}  // namespace knuckle
