#include "sim/rig/import/gltf/gltf_prepared.h"

#include <functional>
#include <initializer_list>
#include <set>
#include <utility>

#include "sim/rig/import/gltf/gltf_extensions.h"
#include "sim/rig/import/gltf/gltf_floats.h"
#include "sim/rig/import/gltf/gltf_keys.h"
#include "sim/rig/import/gltf/gltf_meshopt.h"
#include "sim/rig/import/gltf/gltf_shapes.h"
#include "sim/rig/import/gltf/gltf_source.h"
#include "sim/rig/import/gltf/joint_names.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

Json extensionOf(const Json& entry, const char* name)
{
    return entry.value("extensions", Json::object()).value(name, Json());
}

/// If a material has no other colour, uses the diffuse one of KHR_materials_pbrSpecularGlossiness.
void supplyColors(GltfSource& source)
{
    if (!source.root.contains("materials")) return;
    for (Json& material : source.root["materials"]) {
        const Json old = extensionOf(material, "KHR_materials_pbrSpecularGlossiness");
        Json plain = material.value("pbrMetallicRoughness", Json::object());
        if (!old.is_object() || plain.contains("baseColorFactor") || plain.contains("baseColorTexture")) continue;
        if (old.contains("diffuseFactor")) plain["baseColorFactor"] = old["diffuseFactor"];
        if (old.contains("diffuseTexture")) plain["baseColorTexture"] = old["diffuseTexture"];
        material["pbrMetallicRoughness"] = plain;
    }
}

/// In a file without a scene, all nodes form one.
void supplyScene(GltfSource& source)
{
    const Json& nodes = source.list("nodes");
    if (!source.list("scenes").empty() || nodes.empty()) return;
    std::set<size_t> roots;
    for (size_t n = 0; n < nodes.size(); ++n) roots.insert(n);
    for (const Json& node : nodes)
        for (const Json& child : node.value("children", Json::array())) roots.erase(child.get<size_t>());
    source.root["scenes"] = Json::array({{{"nodes", roots}}});
    source.root["scene"] = 0;
}

}  // namespace

PreparedGltf prepareGltf(const std::string& path)
{
    const std::unique_ptr<GltfSource> source = GltfSource::open(path);
    if (!source) return {};
    PreparedGltf prepared;
    prepared.notes = unreadExtensions(*source);
    prepared.missing = unreadPictures(*source);
    const Json before = source->root;
    const auto name = [&](GltfSource& gltf) { prepared.originals = nameJoints(gltf.root); };
    using Step = std::function<void(GltfSource&)>;
    for (const Step& step :
         std::initializer_list<Step>{supplyScene, decodeMeshopt, supplyPictures, name, supplyBindMatrices,
                                     supplyLinearKeys, applyShapes, supplyFloats, supplyColors}) {
        try {
            step(*source);
        } catch (const Json::exception&) {
            // A field is missing or has another type: assimp reports it, or does not need it.
        }
    }
    if (source->root == before) return prepared;
    prepared.bytes = source->bytes();
    prepared.added = source->added();
    return prepared;
}

}  // namespace knuckle
