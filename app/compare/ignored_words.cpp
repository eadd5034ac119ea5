#include "app/compare/ignored_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <string_view>

#include "sim/base/errors.h"

namespace knuckle {

PixelBox parseBox(const std::string& where, const std::string& word)
{
    std::array<uint32_t, 4> numbers{};
    const char* at = word.data();
    const char* const end = at + word.size();
    const std::string_view between = ",,x";
    bool good = true;
    for (size_t i = 0; i < numbers.size() && good; ++i) {
        const auto [next, error] = std::from_chars(at, end, numbers[i]);
        good = error == std::errc() && (i == 3 ? next == end : next != end && *next == between[i]);
        at = next + (good && i < 3 ? 1 : 0);
    }
    if (!good || numbers[2] == 0 || numbers[3] == 0)
        throw InputError(
            fmt::format("{} {}: must be X,Y,WxH in pixels from the top left, such as 10,20,64x32", where, word));
    return {numbers[0], numbers[1], numbers[2], numbers[3]};
}

std::array<uint8_t, 3> parseColor(const std::string& where, const std::string& word)
{
    const std::string digits = word.starts_with('#') ? word.substr(1) : word;
    const bool good = digits.size() == 6 && std::ranges::all_of(digits, [](unsigned char c) { return isxdigit(c); });
    if (!good)
        throw InputError(fmt::format("{} {}: must be a colour as RRGGBB in hexadecimal, such as ff00ff", where, word));
    std::array<uint8_t, 3> color{};
    for (size_t c = 0; c < 3; ++c) color[c] = static_cast<uint8_t>(std::stoi(digits.substr(2 * c, 2), nullptr, 16));
    return color;
}

}  // namespace knuckle
