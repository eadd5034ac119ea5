#include "app/film/frame_range.h"

#include <fmt/format.h>

#include "sim/base/errors.h"

namespace knuckle {

FrameRange FrameRange::parse(const std::string& text)
{
    if (text == "last") return {.onlyLast = true};
    const auto number = [&](const std::string& part, uint64_t missing) {
        if (part.empty()) return missing;
        const bool digits = part.size() <= 9 && part.find_first_not_of("0123456789") == std::string::npos;
        if (!digits || std::stoull(part) == 0) {
            throw InputError(fmt::format("--frames {}: must be A:B, frames from 1, for instance 1:60, or last", text));
        }
        return static_cast<uint64_t>(std::stoull(part));
    };
    const size_t colon = text.find(':');
    if (colon == std::string::npos) return {number(text.empty() ? "?" : text, 0), number(text, 0)};
    const FrameRange range{number(text.substr(0, colon), 0), number(text.substr(colon + 1), 0)};
    if (range.last != 0 && range.last < range.first) {
        throw InputError(fmt::format("--frames {}: the last frame comes before the first; exchange them", text));
    }
    return range;
}

FrameRange FrameRange::of(const Scene& scene, uint64_t begin) const
{
    const uint64_t count = scene.frameCount();
    if (onlyLast) return {count, count, stride};
    const FrameRange range{first == 0 ? begin : first, last == 0 ? count : last, stride};
    if (begin <= range.first && range.first <= range.last && range.last <= count) return range;
    throw InputError(fmt::format("--frames {}:{}: the scene has frames {} to {}; choose among them or raise /duration",
                                 range.first, range.last, begin, count));
}

}  // namespace knuckle
