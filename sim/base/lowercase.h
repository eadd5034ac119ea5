#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace knuckle {

/// Changes ASCII letters only.
inline std::string lowercase(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

}  // namespace knuckle
