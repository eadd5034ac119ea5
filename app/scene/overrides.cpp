#include "app/scene/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

[[noreturn]] void fail(const Override& change, const std::string& message)
{
    throw InputError(fmt::format("--set {}: {}", change.path, message));
}

/// Whether it is written like a number and is none, or one without end: nan, -inf, 1e999.
bool isNoFiniteNumber(const std::string& value)
{
    char* end = nullptr;
    const double number = std::strtod(value.c_str(), &end);
    return !value.empty() && *end == '\0' && !std::isfinite(number);
}

Json& childOf(Json& parent, const std::string& key, const Override& change)
{
    if (parent.is_null()) parent = Json::object();
    if (parent.is_object()) return parent[key];
    if (!parent.is_array()) fail(change, fmt::format("there is nothing below \"{}\" to set", key));
    const bool number = !key.empty() && key.size() < 10 && std::all_of(key.begin(), key.end(), ::isdigit);
    if (!number || std::stoul(key) >= parent.size()) {
        fail(change, fmt::format("\"{}\" is not one of the list's {} places; they count from 0", key, parent.size()));
    }
    return parent[std::stoul(key)];
}

/// A key as it stands in a JSON pointer.
void unescape(std::string& key)
{
    for (const auto& [escape, letter] : {std::pair{"~1", '/'}, std::pair{"~0", '~'}})
        for (size_t at = 0; (at = key.find(escape, at)) != std::string::npos; ++at)
            key.replace(at, 2, 1, letter);
}

}  // namespace

Override parseOverride(const std::string& text)
{
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw InputError(fmt::format("--set {}: must be path=value, for instance solver.substeps=8", text));
    }
    const std::string value = text.substr(equals + 1);
    if (isNoFiniteNumber(value))
        throw InputError(fmt::format("--set {}: {} is no finite number; give one, or a word in quotes", text, value));
    Json parsed = Json::parse(value, nullptr, false);
    return {text.substr(0, equals), parsed.is_discarded() ? Json(value) : parsed};
}

void applyOverride(Json& root, const Override& change)
{
    // As errors tell a place, or as words.
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
