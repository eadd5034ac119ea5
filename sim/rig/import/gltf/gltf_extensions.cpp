#include "sim/rig/import/gltf/gltf_extensions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace knuckle {

namespace {

using Json = nlohmann::json;

/// Extensions that are read, or that change nothing that is read.
constexpr std::array KNOWN{"EXT_meshopt_compression", "KHR_meshopt_compression",    "EXT_texture_webp",
                           "KHR_texture_basisu",      "KHR_draco_mesh_compression", "KHR_lights_punctual",
                           "KHR_mesh_quantization",   "KHR_texture_transform",      "KHR_xmp_json_ld"};
constexpr std::string_view MATERIALS = "KHR_materials_";

const Json* pictureOf(const Json& texture, const char* extension)
{
    const auto extensions = texture.find("extensions");
    if (extensions == texture.end() || !extensions->is_object()) return nullptr;
    const auto found = extensions->find(extension);
    return found == extensions->end() || !found->contains("source") ? nullptr : &(*found)["source"];
}

}  // namespace

void supplyPictures(GltfSource& source)
{
    Json textures = source.list("textures");
    for (Json& texture : textures) {
        const Json* picture = pictureOf(texture, "EXT_texture_webp");
        if (picture != nullptr && !texture.contains("source")) texture["source"] = Json(*picture);
    }
    if (textures != source.list("textures")) source.root["textures"] = std::move(textures);
}

std::vector<std::string> unreadExtensions(const GltfSource& source)
{
    std::vector<std::string> notes;
    for (const Json& entry : source.list("extensionsRequired")) {
        const std::string name = entry.is_string() ? entry.get<std::string>() : "";
        if (name.empty() || name.starts_with(MATERIALS) || std::ranges::find(KNOWN, name) != KNOWN.end()) continue;
        notes.push_back(
            fmt::format("The file requires '{}', which is not known here: what it stands for is missing.", name));
    }
    return notes;
}

std::vector<std::string> unreadPictures(const GltfSource& source)
{
    std::vector<std::string> notes;
    const Json& textures = source.list("textures");
    for (size_t t = 0; t < textures.size(); ++t)
        if (!textures[t].contains("source") && pictureOf(textures[t], "KHR_texture_basisu") != nullptr)
            notes.push_back(fmt::format("Texture {} is a KTX2 picture, which is not read: drawn plain.", t));
    return notes;
}

}  // namespace knuckle
