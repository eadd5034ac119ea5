#pragma once

#include <span>
#include <string>

namespace knuckle {

/// "a, b, c"; for more than `most` names "a, b and 13 more", with most - 1 parts. @param most 2 or more.
std::string shortList(std::span<const std::string> names, size_t most = 4);

}  // namespace knuckle
