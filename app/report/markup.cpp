#include "app/report/markup.h"

#include <cstddef>
#include <cstdint>

#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

constexpr const char* REPLACEMENT = "\uFFFD";

/// What stands for a character of its own meaning; nothing for others.
const char* entityOf(char c)
{
    switch (c) {
        case '&': return "&amp;";
        case '<': return "&lt;";
        case '>': return "&gt;";
        case '"': return "&quot;";
        case '\'': return "&#39;";
        case '\t': return "&#9;";
        case '\n': return "&#10;";
        case '\r': return "&#13;";
        default: return static_cast<uint8_t>(c) < 0x20 || c == 0x7F ? REPLACEMENT : nullptr;
    }
}

}  // namespace

std::string escapedMarkup(std::string_view text)
{
    const std::string valid = validText(text);
    std::string escaped;
    for (size_t i = 0; i < valid.size(); ++i) {
        const std::string_view next = std::string_view(valid).substr(i, 3);
        if (const char* entity = entityOf(valid[i])) {
            escaped += entity;
        } else if (next == "\xEF\xBF\xBE" || next == "\xEF\xBF\xBF") {
            escaped += REPLACEMENT;
            i += 2;
        } else {
            escaped += valid[i];
        }
    }
    return escaped;
}

}  // namespace knuckle
