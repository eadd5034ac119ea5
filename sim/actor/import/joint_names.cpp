#include "sim/actor/import/joint_names.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>

#include "sim/actor/import/lowercase.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

constexpr size_t HEADER = 12, CHUNK_HEADER = 8;  // of a binary glTF [bytes]

uint32_t numberAt(const std::string& bytes, size_t place)
{
    uint32_t number = 0;
    std::memcpy(&number, bytes.data() + place, sizeof number);
    return number;
}

void setNumber(std::string& bytes, size_t place, size_t number)
{
    const auto value = static_cast<uint32_t>(number);
    std::memcpy(bytes.data() + place, &value, sizeof value);
}

/// Where the JSON of a file stands: all of it, or the first chunk of a binary one.
struct JsonPlace {
    size_t start = 0, length = 0;
};

JsonPlace jsonIn(const std::string& bytes)
{
    if (!bytes.starts_with("glTF")) return {0, bytes.size()};
    const size_t start = HEADER + CHUNK_HEADER;
    if (bytes.size() < start) return {};
    const size_t length = numberAt(bytes, HEADER);
    return length <= bytes.size() - start ? JsonPlace{start, length} : JsonPlace{};
}

std::string nameOf(const Json& node)
{
    return node.value("name", std::string());
}

/// @returns by the new names what they were before.
std::map<std::string, std::string> rename(Json& gltf)
{
    std::map<std::string, std::string> originals;
    if (!gltf.contains("skins") || !gltf.contains("nodes")) return originals;
    std::set<size_t> joints;
    for (const Json& skin : gltf["skins"])
        for (const Json& joint : skin.at("joints")) joints.insert(joint.get<size_t>());
    std::set<std::string> names;
    for (const Json& node : gltf["nodes"]) names.insert(nameOf(node));
    std::map<std::string, int> seen;
    for (const size_t joint : joints) {
        Json& node = gltf["nodes"].at(joint);
        const std::string name = nameOf(node);
        if (name.empty() || ++seen[name] == 1) continue;
        int number = seen[name];
        std::string unique = fmt::format("{}#{}", name, number);
        while (names.contains(unique)) unique = fmt::format("{}#{}", name, ++number);
        names.insert(unique);
        originals[unique] = name;
        node["name"] = unique;
    }
    return originals;
}

}  // namespace

NamedJoints nameJoints(const std::string& path)
{
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    if (extension != ".glb" && extension != ".gltf") return {};
    std::ifstream file(path, std::ios::binary);
    NamedJoints named{{std::istreambuf_iterator<char>(file), {}}, {}};
    const JsonPlace place = jsonIn(named.bytes);
    const bool isBinary = place.start > 0;
    try {
        Json gltf = Json::parse(named.bytes.begin() + static_cast<std::ptrdiff_t>(place.start),
                                named.bytes.begin() + static_cast<std::ptrdiff_t>(place.start + place.length));
        named.originals = rename(gltf);
        if (named.originals.empty()) return {};
        std::string text = gltf.dump(-1, ' ', false, Json::error_handler_t::replace);
        if (isBinary) text.resize((text.size() + 3) / 4 * 4, ' ');
        named.bytes.replace(place.start, place.length, text);
        if (isBinary) setNumber(named.bytes, HEADER, text.size());
        if (isBinary) setNumber(named.bytes, 8, named.bytes.size());
    } catch (const Json::exception&) {
        return {};  // assimp says what is wrong
    }
    return named;
}

}  // namespace knuckle
