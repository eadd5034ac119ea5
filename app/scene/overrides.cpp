#include "app/scene/overrides.h"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

[[noreturn]] void fail(const Override& change, const std::string& message)
{
    throw InputError(fmt::format("--set {}: {}", change.path, message));
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

}  // namespace

Override parseOverride(const std::string& text)
{
    const size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0) {
        throw InputError(fmt::format("--set {}: must be path=value, for instance solver.substeps=8", text));
    }
    const std::string value = text.substr(equals + 1);
    Json parsed = Json::parse(value, nullptr, false);
    return {text.substr(0, equals), parsed.is_discarded() ? Json(value) : parsed};
}

void applyOverride(Json& root, const Override& change)
{
    std::istringstream path(change.path);
    std::string key;
    Json* place = &root;
    while (std::getline(path, key, '.')) {
        if (key.empty()) fail(change, "a part of the path is empty");
        place = &childOf(*place, key, change);
    }
    *place = change.value;
}

}  // namespace knuckle
