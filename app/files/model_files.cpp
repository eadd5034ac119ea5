#include "app/files/model_files.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "sim/base/files/endings.h"
#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr uintmax_t MOST_BYTES = uintmax_t{256} << 20;  // larger ones are not searched

/// Adds `name` unchanged and with its escapes decoded.
void add(std::vector<std::string>& files, const std::string& model, const std::string& name)
{
    if (name.empty() || name.starts_with("data:")) return;
    for (const std::string& text : {name, decodedUri(name)})
        files.push_back((fs::path(model).parent_path() / text).string());
}

std::vector<std::string> filesOfGltf(const std::string& path)
{
    std::vector<std::string> files;
    const auto source = GltfSource::open(path);
    for (const char* list : {"buffers", "images"}) {
        if (!source) break;
        for (const auto& entry : source->list(list))
            if (entry.is_object() && entry.contains("uri") && entry["uri"].is_string()) add(files, path, entry["uri"]);
    }
    return files;
}

/// The last words of lines with this start.
std::vector<std::string> named(const std::string& path, const char* start)
{
    std::vector<std::string> files;
    std::ifstream file(path);
    for (std::string line; std::getline(file, line);) {
        std::istringstream words(line);
        std::string first, last;
        words >> first;
        while (words >> last) continue;
        if (first.starts_with(start)) add(files, path, last);
    }
    return files;
}

}  // namespace

std::vector<std::string> filesOfModel(const std::string& path)
{
    std::error_code error;
    const auto byteCount = fs::file_size(path, error);
    if (error || byteCount > MOST_BYTES) return {};
    const std::string ending = endingOf(path);
    if (ending == ".gltf" || ending == ".glb") return filesOfGltf(path);
    if (ending != ".obj") return {};
    std::vector<std::string> files = named(path, "mtllib");
    for (const std::string& materials : std::vector(files))
        for (const std::string& picture : named(materials, "map_")) files.push_back(picture);
    return files;
}

}  // namespace knuckle
