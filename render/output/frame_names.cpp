#include "render/output/frame_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

namespace {

constexpr std::string_view DIGITS = "0123456789";

/// Whether one is the other with digits behind it, which a number may add.
bool mayBeSame(std::string_view a, std::string_view b)
{
    if (a.size() > b.size()) std::swap(a, b);
    return b.starts_with(a) && b.substr(a.size()).find_first_not_of(DIGITS) == std::string_view::npos;
}

}  // namespace

bool FrameNames::areGivenBy(const std::string& output)
{
    return !output.ends_with('/') && std::ranges::count(PICTURE_ENDINGS, endingOf(output)) > 0 &&
           OutputPlace::of(output).kind == OutputPlace::Kind::File;
}

FrameNames FrameNames::of(const std::string& output)
{
    if (!areGivenBy(output)) return {.folder = output};
    const size_t slash = output.rfind('/'), begin = slash == std::string::npos ? 0 : slash + 1;
    const std::string name = output.substr(begin);
    FrameNames names{.folder = begin == 0 ? "." : output.substr(0, begin), .digits = 0, .given = true};
    const size_t first = name.find('#'), end = std::min(name.find_first_not_of('#', first), name.size());
    if (first == std::string::npos) {
        names.before = name.substr(0, name.rfind('.'));
        names.after = name.substr(name.rfind('.'));
        return names;
    }
    if (name.find('#', end) != std::string::npos)
        throw InputError(fmt::format("-o {}: has # at several places; give the frame's number one", output));
    names.before = name.substr(0, first);
    names.after = name.substr(end);
    names.digits = end - first;
    return names;
}

std::string FrameNames::path(uint64_t number) const
{
    const std::string digit = digits == 0 ? "" : fmt::format("{:0{}}", number, digits);
    return fmt::format("{}/{}{}{}", folder, before, digit, after);
}

bool FrameNames::has(const std::string& name) const
{
    if (name.size() < before.size() + digits + after.size() || !name.starts_with(before) || !name.ends_with(after))
        return false;
    const std::string number = name.substr(before.size(), name.size() - before.size() - after.size());
    return digits == 0 ? number.empty() : number.find_first_not_of(DIGITS) == std::string::npos;
}

bool FrameNames::areJpeg() const
{
    const std::string ending = endingOf("a" + after);
    return ending == PICTURE_ENDINGS[1] || ending == PICTURE_ENDINGS[2];
}

bool FrameNames::areExr() const
{
    return endingOf("a" + after) == PICTURE_ENDINGS[3];
}

bool FrameNames::mayMeet(const FrameNames& other) const
{
    // Folders that are given for frames of their own are not shared, whatever lies in them.
    if (!given && !other.given) return true;
    return after == other.after && mayBeSame(before, other.before);
}

}  // namespace knuckle
