#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace knuckle {

/// Code points of UTF-8; what is none of it becomes U+FFFD.
std::vector<uint32_t> codePointsOf(std::string_view text);

/// UTF-8 of code points; what is none becomes U+FFFD.
std::string utf8Of(const std::vector<uint32_t>& codePoints);

}  // namespace knuckle
