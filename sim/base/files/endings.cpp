#include "sim/base/files/endings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "sim/base/errors.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

std::string endingOf(const std::string& path)
{
    std::string ending = std::filesystem::path(path).extension().string();
    const auto is = [](auto test) { return [test](unsigned char c) { return test(c) != 0; }; };
    const auto letters = ending.empty() ? ending.end() : std::next(ending.begin());
    if (!std::all_of(letters, ending.end(), is(isalnum)) || std::none_of(letters, ending.end(), is(isalpha))) return {};
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return ending;
}

void requireEnding(const std::string& option, const std::string& path, const char* what,
                   const std::vector<const char*>& endings)
{
    const OutputPlace place = OutputPlace::of(path);
    if (place.kind == OutputPlace::Kind::Stream) return;
    const std::string ending = endingOf(path);
    std::string known;
    for (const std::string_view candidate : endings) {
        if (candidate == ending) return;
        if (!candidate.empty()) known += fmt::format("{}{}", known.empty() ? "" : " or ", candidate);
    }
    throw InputError(fmt::format("{}{}: {} is written as {}; name it so, or - for standard output", option, place.given,
                                 what, known));
}

void requireFolder(const std::string& option, const std::string& path, const char* what)
{
    const OutputPlace place = OutputPlace::of(path);
    if (place.kind == OutputPlace::Kind::Stream)
        throw InputError(fmt::format("{}{}: {} are written into a folder; name one", option, place.given, what));
    if (place.kind == OutputPlace::Kind::File && !endingOf(path).empty())
        throw InputError(
            fmt::format("{0}{1}: {2} are written into a folder; name one, or {1}/", option, place.given, what));
}

}  // namespace knuckle
