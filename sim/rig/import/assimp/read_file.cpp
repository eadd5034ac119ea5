#include "sim/rig/import/assimp/read_file.h"

#include <assimp/DefaultIOSystem.h>
#include <assimp/MemoryIOWrapper.h>

#include <assimp/Importer.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string_view>
#include <utility>

#include "sim/base/lowercase.h"
#include "sim/rig/import/bvh/bvh_text.h"
#include "sim/rig/import/gltf/gltf_prepared.h"
#include "sim/rig/import/gltf/gltf_source.h"

namespace knuckle {

namespace {

/// Gives assimp the bytes of a changed glTF and of the data added to it; other files unchanged, with names decoded from
/// URIs.
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

const aiScene* readFile(Assimp::Importer& importer, const std::string& path, unsigned flags, const ModelPick& pick,
                        FileNames& names)
{
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    if (extension == ".bvh") {
        std::ifstream file(path, std::ios::binary);
        PreparedBvh prepared = prepareBvh({std::istreambuf_iterator<char>(file), {}}, pick.skeleton);
        names = {std::move(prepared.originals), std::move(prepared.notes), {}};
        return importer.ReadFileFromMemory(prepared.text.data(), prepared.text.size(), flags, "bvh");
    }
    PreparedGltf prepared = prepareGltf(path);
    names = {prepared.originals, prepared.notes, prepared.missing};
    if (extension == ".gltf" || extension == ".glb")
        importer.SetIOHandler(new GltfFiles(path, std::move(prepared)));  // the importer owns it
    return importer.ReadFile(path, flags);
}

}  // namespace knuckle
