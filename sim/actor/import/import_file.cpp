#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "sim/actor/import/gltf/gltf_prepared.h"
#include "sim/actor/import/gltf/gltf_source.h"
#include "sim/actor/import/import_scene.h"
#include "sim/actor/import/lowercase.h"

namespace knuckle {

namespace {

constexpr std::string_view BYTE_ORDER_MARK = "\xEF\xBB\xBF";

/// Gives the bytes of a changed glTF and of what was added to it; other files as they are, those that it names in the
/// words of an URI by what these stand for.
class GltfFiles : public Assimp::DefaultIOSystem {
public:
    GltfFiles(std::string path, PreparedGltf prepared) : path_(std::move(path)), prepared_(std::move(prepared)) {}

    bool Exists(const char* file) const override { return isAdded(file) || DefaultIOSystem::Exists(file); }

    Assimp::IOStream* Open(const char* file, const char* mode) override
    {
        if (isAdded(file)) return inMemory(prepared_.added);
        if (path_ == file && !prepared_.bytes.empty()) return inMemory(prepared_.bytes);
        if (path_ == file || DefaultIOSystem::Exists(file)) return DefaultIOSystem::Open(file, mode);
        return DefaultIOSystem::Open(decodedUri(file).c_str(), mode);
    }

private:
    bool isAdded(std::string_view file) const
    {
        return !prepared_.added.empty() && file.ends_with(GltfSource::ADDED_FILE);
    }
    static Assimp::IOStream* inMemory(const std::string& bytes)
    {
        return new Assimp::MemoryIOStream(reinterpret_cast<const uint8_t*>(bytes.data()), bytes.size());
    }

    std::string path_;
    PreparedGltf prepared_;
};

}  // namespace

const aiScene* readFile(Assimp::Importer& importer, const std::string& path, unsigned flags,
                        std::map<std::string, std::string>& originals)
{
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    PreparedGltf prepared = prepareGltf(path);
    originals = prepared.originals;
    if (extension == ".gltf" || extension == ".glb")
        importer.SetIOHandler(new GltfFiles(path, std::move(prepared)));  // the importer owns it
    // assimp takes a BVH file with a byte-order mark for none: it gets what follows the mark.
    std::string start(BYTE_ORDER_MARK.size(), '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(start.data(), static_cast<std::streamsize>(start.size()));
    if (extension != ".bvh" || start != BYTE_ORDER_MARK) return importer.ReadFile(path, flags);
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    return importer.ReadFileFromMemory(text.data(), text.size(), flags, "bvh");
}

}  // namespace knuckle
