#pragma once

#include <span>
#include <string>

namespace knuckle {

/// "a, b, c", of more than `most` names "a, b and 13 more" with one less than that. @param most 2 or more.
std::string shortList(std::span<const std::string> names, size_t most = 4);

}  // namespace knuckle
