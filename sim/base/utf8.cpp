#include "sim/base/utf8.h"

namespace knuckle {

namespace {

constexpr uint32_t REPLACEMENT = 0xfffd;

/// Bytes that follow the first one of a letter; -1: it is none.
int followers(uint8_t first)
{
    if (first < 0x80) return 0;
    if (first >= 0xc2 && first < 0xe0) return 1;
    if (first >= 0xe0 && first < 0xf0) return 2;
    return first >= 0xf0 && first < 0xf5 ? 3 : -1;
}

}  // namespace

std::vector<uint32_t> codePointsOf(std::string_view text)
{
    std::vector<uint32_t> points;
    for (size_t i = 0; i < text.size();) {
        const auto first = static_cast<uint8_t>(text[i++]);
        const int more = followers(first);
        uint32_t point = more <= 0 ? first : first & (0x3fu >> more);
        int found = 0;
        while (found < more && i < text.size() && (static_cast<uint8_t>(text[i]) & 0xc0) == 0x80) {
            point = point << 6 | (static_cast<uint8_t>(text[i++]) & 0x3fu);
            ++found;
        }
        points.push_back(more < 0 || found < more ? REPLACEMENT : point);
    }
    return points;
}

std::string utf8Of(const std::vector<uint32_t>& codePoints)
{
    std::string text;
    for (const uint32_t given : codePoints) {
        const bool isSurrogate = given >= 0xd800 && given < 0xe000;
        const uint32_t point = given > 0x10ffff || isSurrogate ? REPLACEMENT : given;
        const int more = point < 0x80 ? 0 : point < 0x800 ? 1 : point < 0x10000 ? 2 : 3;
        text += static_cast<char>(more == 0 ? point : (0xff80u >> more & 0xffu) | point >> 6 * more);
        for (int k = more; k-- > 0;) text += static_cast<char>(0x80u | (point >> 6 * k & 0x3fu));
    }
    return text;
}

}  // namespace knuckle
