#include "sim/actor/import/file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "sim/actor/import/gltf/gltf_source.h"
#include "sim/actor/import/lowercase.h"
#include "sim/world/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// What assimp's readers say where a file ends too early.
constexpr std::array CUT_OFF_WORDS{"end of file", "eof",       "out of range", "exceeds size",
                                   "too small",   "truncated", "keyword \"\"", "invalid number of"};

void checkBuffer(const fs::path& folder, const Json& buffer)
{
    const std::string uri = buffer.is_object() ? buffer.value("uri", std::string()) : std::string();
    if (uri.empty() || uri.starts_with("data:")) return;
    std::error_code error;
    const std::string name = fs::exists(folder / uri, error) ? uri : decodedUri(uri);
    const uintmax_t size = fs::file_size(folder / name, error);
    if (error)
        throw InputError(
            fmt::format("its file '{}' is not beside it: put it there, or export a .glb, which holds all", name));
    const uint64_t wanted = buffer.value("byteLength", uint64_t{0});
    if (size < wanted)
        throw InputError(fmt::format("its file '{}' is cut off: {} of {} bytes are there; export the model again", name,
                                     size, wanted));
}

/// The file's name with another ending.
std::string renamed(const std::string& path, const char* extension)
{
    return fs::path(path).filename().replace_extension(extension).string();
}

void checkGlb(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    char first = 0;
    file >> first;
    if (first == '{')
        throw InputError(fmt::format("it is a glTF of text under the name of a binary one: rename it to {}",
                                     renamed(path, ".gltf")));
}

void checkGltf(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    std::string magic(4, '\0');
    file.read(magic.data(), 4);
    if (magic == "glTF")
        throw InputError(
            fmt::format("it is a binary glTF under the name of one of text: rename it to {}", renamed(path, ".glb")));
    file.clear();
    file.seekg(0);
    const Json json = Json::parse(file, nullptr, false);
    if (json.is_discarded())
        throw InputError("it is cut off or damaged (its JSON cannot be read); export the model again");
    try {
        for (const Json& buffer : json.value("buffers", Json::array()))
            checkBuffer(fs::path(path).parent_path(), buffer);
    } catch (const Json::exception&) {
        // A field of another type: assimp says which.
    }
}

}  // namespace

void checkParts(const std::string& path)
{
    const std::string name = lowercase(fs::path(path).filename().string());
    if (name.ends_with(".skeleton") || name.ends_with(".skeleton.xml"))
        throw InputError("it is a skeleton of Ogre without its mesh: give the .mesh or .mesh.xml that goes with it");
    if (name.ends_with(".gltf")) checkGltf(path);
    if (name.ends_with(".glb")) checkGlb(path);
}

std::string unreadableBecause(const std::string& reason)
{
    const std::string words = lowercase(reason);
    if (std::ranges::any_of(CUT_OFF_WORDS, [&](const char* cut) { return words.find(cut) != std::string::npos; }))
        return fmt::format("it is cut off or damaged ({}); export the model again", reason);
    return fmt::format("it cannot be read as a model ({}); export it as glTF, FBX, Collada or BVH",
                       reason.empty() ? "it holds no scene" : reason);
}

void noteMissingMaterials(const std::string& path, ModelSurface& surface)
{
    constexpr std::string_view NAMES = "mtllib ";
    if (lowercase(fs::path(path).extension().string()) != ".obj") return;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        if (!line.starts_with(NAMES)) continue;
        std::string name = line.substr(NAMES.size());
        name.erase(name.find_last_not_of(" \r\t") + 1);
        std::error_code error;
        if (!fs::is_regular_file(fs::path(path).parent_path() / name, error))
            surface.notes.push_back(fmt::format("Material file '{}' is not beside the model: drawn plain.", name));
    }
}

}  // namespace knuckle
