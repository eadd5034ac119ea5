#include "sim/gpu/buffer_table.h"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

#include "sim/world/errors.h"

namespace knuckle {

namespace {

constexpr std::string_view LAST = "last";

[[noreturn]] void refuse(const std::string& name, const std::string& user)
{
    throw DeviceError(fmt::format("{} declares \"{}\", which is not among what it is given", user, name));
}

}  // namespace

const BufferTable::Entry& BufferTable::find(const std::string& name, const std::string& user) const
{
    auto found = entries_.find(name);
    if (found == entries_.end() && name.starts_with(LAST) && name.size() > LAST.size()) {
        std::string own = name.substr(LAST.size());
        own[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(own[0])));
        found = entries_.find(own);
    }
    if (found == entries_.end()) refuse(name, user);
    return found->second;
}

const Texture& BufferTable::findTexture(const std::string& name, const std::string& user) const
{
    const auto found = textures_.find(name);
    if (found == textures_.end()) refuse(name, user);
    return *found->second;
}

BufferTable BufferTable::only(std::initializer_list<std::string> names, const std::string& user) const
{
    BufferTable part;
    for (const std::string& name : names) {
        const auto texture = textures_.find(name);
        if (texture != textures_.end()) part.add(*texture->second);
        else part.entries_[name] = find(name, user);
    }
    return part;
}

}  // namespace knuckle
