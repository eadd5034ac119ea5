#include "sim/rig/import/file_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <span>
#include <string_view>

#include "sim/base/errors.h"
#include "sim/base/json.h"
#include "sim/base/lowercase.h"
#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

/// Words of assimp's readers for a file that ends too early.
constexpr std::array CUT_OFF_WORDS{"end of file", "eof",          "out of range",      "exceeds size", "too small",
                                   "truncated",   "keyword \"\"", "invalid number of", "malformed xml"};

/// Words for whole files without a mesh.
constexpr std::array NO_MESH_WORDS{"no root node",      "came out empty", "unable to extract mesh",
                                   "no valid vertices", "no vertices",    "no objects dictionary",
                                   "no meshes",         "no geometry",    "no valid geometry",
                                   "no facets",         "gltf: no scene", "obj-file is too small"};

bool holdsAny(const std::string& text, std::span<const char* const> words)
{
    return std::ranges::any_of(words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// The version in an FBX file, 7400 for 7.4; 0 if there is none.
uint32_t fbxVersion(const std::string& path)
{
    constexpr size_t BINARY_VERSION_AT = 23, LOOKED_THROUGH = 4096;
    std::string start(LOOKED_THROUGH, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    start.resize(static_cast<size_t>(file.gcount()));
    uint32_t version = 0;
    if (start.starts_with("Kaydara FBX Binary") && start.size() >= BINARY_VERSION_AT + sizeof version) {
        std::memcpy(&version, start.data() + BINARY_VERSION_AT, sizeof version);
        return version;
    }
    constexpr std::string_view WORD = "FBXVersion:";
    const size_t at = start.find(WORD);
    return at == std::string::npos ? 0u
                                   : static_cast<uint32_t>(std::strtoul(start.c_str() + at + WORD.size(), nullptr, 10));
}

void checkFbx(const std::string& path)
{
    constexpr uint32_t OLDEST = 7100;  // that assimp reads
    const uint32_t version = fbxVersion(path);
    if (version == 0 || version >= OLDEST) return;
    throw InputError(
        fmt::format("it is an FBX of version {}.{}, as programs wrote before 2011, which is not read: convert "
                    "it to FBX 2011 or later, or to glTF",
                    version / 1000, version / 100 % 10));
}

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

/// The file's name with another extension.
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
        // A field has another type: assimp reports it.
    }
}

}  // namespace

void checkParts(const std::string& path)
{
    const std::string name = lowercase(fs::path(path).filename().string());
    if (name.ends_with(".skeleton") || name.ends_with(".skeleton.xml"))
        throw InputError("it is a skeleton of Ogre without its mesh: give the .mesh or .mesh.xml that goes with it");
    if (name.ends_with(".fbx")) checkFbx(path);
    if (name.ends_with(".gltf")) checkGltf(path);
    if (name.ends_with(".glb")) checkGlb(path);
}

std::string unreadableBecause(const std::string& reason)
{
    const std::string words = lowercase(reason);
    if (holdsAny(words, NO_MESH_WORDS)) return NO_MESH;
    if (holdsAny(words, CUT_OFF_WORDS))
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
            surface.missing.push_back(fmt::format("Material file '{}' is not beside the model: drawn plain.", name));
    }
}

}  // namespace knuckle
