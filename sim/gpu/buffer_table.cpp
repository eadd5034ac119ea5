#include "sim/gpu/buffer_table.h"

#include <fmt/format.h>

#include <cctype>
#include <stdexcept>
#include <string_view>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

constexpr std::string_view LAST = "last";

[[noreturn]] void refuse(const std::string& name, const std::string& user)
{
    throw DeviceError(fmt::format("{} declares \"{}\", which is not among what it is given", user, name));
}

/// "positions" of "lastPositions"; empty for other names.
std::string withoutLast(const std::string& name)
{
    if (!name.starts_with(LAST)) return "";
    std::string own = name.substr(LAST.size());
    if (!own.empty()) own[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(own[0])));
    return own;
}

}  // namespace

GLenum texelFormat(const ElementType& element)
{
    const bool isFloat = element.scalar == ElementType::Scalar::Float;
    switch (element.texelBytes) {
        case 4: return isFloat ? GL_R32F : GL_R32UI;
        case 8: return isFloat ? GL_RG32F : GL_RG32UI;
        default: return isFloat ? GL_RGBA32F : GL_RGBA32UI;
    }
}

void BufferTable::add(const std::string& name, RawBuffer& buffer, ElementType element, Lifetime lifetime)
{
    if (!entries_.emplace(name, Entry{&buffer, element, lifetime}).second)
        throw std::logic_error(fmt::format("two buffers are named \"{}\"", name));
}

const BufferTable::Entry& BufferTable::find(const std::string& name, const std::string& user) const
{
    auto found = entries_.find(name);
    if (found == entries_.end()) found = entries_.find(withoutLast(name));
    if (found == entries_.end()) refuse(name, user);
    return found->second;
}

const Texture& BufferTable::findTexture(const std::string& name, const std::string& user) const
{
    const auto found = textures_.find(name);
    if (found == textures_.end()) refuse(name, user);
    return *found->second;
}

BufferTable BufferTable::only(const std::vector<std::string>& names, const std::string& user) const
{
    BufferTable part;
    for (const std::string& name : names) {
        const auto texture = textures_.find(name);
        const auto entry = entries_.find(name);
        if (texture == textures_.end() && entry == entries_.end())
            throw DeviceError(fmt::format("{} asks for \"{}\", which is not in the table", user, name));
        if (texture != textures_.end()) part.textures_.insert(*texture);
        else part.entries_.insert(*entry);
    }
    return part;
}

BufferState BufferTable::saveState() const
{
    BufferState state;
    for (const auto& [name, entry] : entries_) {
        if (entry.lifetime != Lifetime::State) continue;
        std::vector<std::byte>& bytes = state[name];
        bytes.resize(entry.buffer->bytes());
        if (!bytes.empty()) entry.buffer->read(bytes.data(), bytes.size());
    }
    return state;
}

void BufferTable::loadState(const BufferState& state) const
{
    const auto refuse = [](const std::string& why) {
        throw std::logic_error(why + "; take one of the same world and settings");
    };
    size_t found = 0;
    for (const auto& [name, entry] : entries_) {
        if (entry.lifetime != Lifetime::State) continue;
        const auto saved = state.find(name);
        if (saved == state.end()) return refuse(fmt::format("the state has no \"{}\", which is carried on here", name));
        if (saved->second.size() != entry.buffer->bytes())
            return refuse(fmt::format("the state has {} bytes of \"{}\", and there are {} here", saved->second.size(),
                                      name, entry.buffer->bytes()));
        ++found;
    }
    if (found != state.size())
        return refuse(fmt::format("the state is of {} buffers, of which {} are carried on here", state.size(), found));
    for (const auto& [name, bytes] : state)
        if (!bytes.empty()) entries_.at(name).buffer->write(bytes.data(), bytes.size());
}

}  // namespace knuckle
