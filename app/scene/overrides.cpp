#include "app/scene/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <utility>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

[[noreturn]] void fail(const Override& change, const std::string& message)
{
    throw InputError(fmt::format("--set {}: {}", change.path, message));
}

/// The whole text as a number, which may be nan or infinite: nan, -inf, 1e999.
std::optional<double> numberIn(const std::string& text)
{
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    return text.empty() || *end != '\0' ? std::nullopt : std::optional(number);
}

/// The same for two numbers separated by a slash.
std::optional<double> fractionIn(const std::string& text)
{
    const size_t slash = text.find('/');
    const auto above = numberIn(text.substr(0, slash)), below = numberIn(text.substr(slash + 1));
    return above && below ? std::optional(*above / *below) : std::nullopt;
}

Json& childOf(Json& parent, const std::string& key, const Override& change)
{
    if (parent.is_null()) parent = key == "-" ? Json::array() : Json::object();
    if (parent.is_object()) return parent[key];
    if (!parent.is_array()) fail(change, fmt::format("there is nothing below \"{}\" to set", key));
    const bool number = !key.empty() && key.size() < 10 && std::all_of(key.begin(), key.end(), ::isdigit);
    if (key == "-") return parent.emplace_back();  // behind the last, as JSON pointers have it
    if (!number || std::stoul(key) >= parent.size()) {
        fail(change, fmt::format("\"{}\" is not one of the list's {} places; they count from 0", key, parent.size()));
    }
    return parent[std::stoul(key)];
}

/// Decodes a key of a JSON pointer.
void unescape(std::string& key)
{
    for (const auto& [escape, letter] : {std::pair{"~1", '/'}, std::pair{"~0", '~'}})
        for (size_t at = 0; (at = key.find(escape, at)) != std::string::npos; ++at) key.replace(at, 2, 1, letter);
}

}  // namespace

Override parseOverride(const std::string& text, const std::string& option)
{
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw InputError(fmt::format("{}{}: must be path=value, for instance solver.substeps=8", option, text));
    }
    const std::string path = text.substr(0, equals), value = text.substr(equals + 1);
    const bool isRate = path == "fps" || path == "/fps";
    const auto number = isRate && value.find('/') != std::string::npos ? fractionIn(value) : numberIn(value);
    if (number && !std::isfinite(*number))
        throw InputError(fmt::format("{}{}: {} is no finite number; give one{}", option, isRate ? value : text, value,
                                     isRate ? ", as 25 or 24000/1001" : ", or a word in quotes"));
    Json parsed = Json::parse(value, nullptr, false);
    if (parsed.is_discarded()) parsed = isRate && number ? Json(*number) : Json(value);
    return {path, parsed};
}

std::array<uint64_t, 2> parsePictureSize(const std::string& text)
{
    const size_t cross = text.find('x');
    const std::string width = text.substr(0, cross), height = cross == std::string::npos ? "" : text.substr(cross + 1);
    for (const std::string& side : {width, height}) {
        if (!side.empty() && side.size() < 9 && side.find_first_not_of("0123456789") == std::string::npos) continue;
        throw InputError(fmt::format("--size {}: must be WIDTHxHEIGHT in pixels, for instance 1280x720", text));
    }
    return {std::stoul(width), std::stoul(height)};
}

void applyOverride(Json& root, const Override& change)
{
    // A pointer, as in errors, or words.
    const bool pointer = change.path.starts_with('/');
    std::istringstream path(pointer ? change.path.substr(1) : change.path);
    std::string key;
    Json* place = &root;
    while (std::getline(path, key, pointer ? '/' : '.')) {
        if (pointer) unescape(key);
        if (key.empty()) fail(change, "a part of the path is empty");
        place = &childOf(*place, key, change);
    }
    *place = change.value;
}

}  // namespace knuckle
