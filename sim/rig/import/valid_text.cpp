#include "sim/rig/import/valid_text.h"

#include <cstddef>
#include <cstdint>

namespace knuckle {

namespace {

/// The length in bytes of the character that begins there; 0: invalid.
size_t characterAt(std::string_view text, size_t place)
{
    const auto byteAt = [&](size_t i) { return i < text.size() ? static_cast<uint8_t>(text[i]) : uint8_t{0}; };
    const uint8_t lead = byteAt(place), second = byteAt(place + 1);
    if (lead < 0x80) return 1;
    if (lead < 0xC2 || lead > 0xF4) return 0;
    const size_t length = lead < 0xE0 ? 2 : lead < 0xF0 ? 3 : 4;
    for (size_t i = 1; i < length; ++i)
        if ((byteAt(place + i) & 0xC0) != 0x80) return 0;
    // Longer than necessary, halves of pairs, beyond the last character.
    const bool isOdd = (lead == 0xE0 && second < 0xA0) || (lead == 0xED && second > 0x9F) ||
                       (lead == 0xF0 && second < 0x90) || (lead == 0xF4 && second > 0x8F);
    return isOdd ? 0 : length;
}

}  // namespace

std::string validText(std::string_view text)
{
    std::string valid;
    for (size_t i = 0; i < text.size();) {
        const size_t length = characterAt(text, i);
        if (length == 0) {
            const auto byte = static_cast<uint8_t>(text[i]);
            valid += static_cast<char>(0xC0 | byte >> 6);
            valid += static_cast<char>(0x80 | (byte & 0x3F));
        }
        valid.append(text.substr(i, length));
        i += length == 0 ? 1 : length;
    }
    return valid;
}

}  // namespace knuckle
