#include "sim/rig/import/gltf/gltf_shapes.h"

#include <algorithm>
#include <set>

#include "sim/base/errors.h"
#include "sim/rig/import/gltf/gltf_floats.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

/// The weights of a mesh: its own, or those of the only node that shows it.
std::vector<float> weightsOf(const GltfSource& source, size_t index)
{
    std::vector<float> weights = source.list("meshes")[index].value("weights", std::vector<float>());
    std::set<std::vector<float>> given;
    for (const Json& node : source.list("nodes"))
        if (node.contains("mesh") && node["mesh"].get<size_t>() == index) given.insert(node.value("weights", weights));
    return given.size() == 1 ? *given.begin() : weights;
}

size_t moved(GltfSource& source, const Json& primitive, const char* attribute, const std::vector<float>& weights)
{
    GltfFloats base = readFloats(source, primitive["attributes"][attribute].get<size_t>(), false);
    const Json& targets = primitive.at("targets");
    for (size_t t = 0; t < std::min(targets.size(), weights.size()); ++t) {
        if (weights[t] == 0.0f || !targets[t].contains(attribute)) continue;
        const GltfFloats shift = readFloats(source, targets[t][attribute].get<size_t>(), false);
        if (shift.values.size() != base.values.size())
            throw InputError("a shape of a mesh has another number of vertices than the mesh: export the model again");
        for (size_t i = 0; i < base.values.size(); ++i) base.values[i] += weights[t] * shift.values[i];
    }
    return source.addFloats(base.values, base.components, base.type);
}

}  // namespace

void applyShapes(GltfSource& source)
{
    Json meshes = source.list("meshes");
    for (size_t m = 0; m < meshes.size(); ++m) {
        const std::vector<float> weights = weightsOf(source, m);
        if (std::ranges::all_of(weights, [](float weight) { return weight == 0.0f; })) continue;
        for (Json& primitive : meshes[m].at("primitives")) {
            const bool isPacked = primitive.value("extensions", Json::object()).contains("KHR_draco_mesh_compression");
            if (isPacked || !primitive.contains("targets")) continue;
            Json& attributes = primitive.at("attributes");
            for (const char* attribute : {"POSITION", "NORMAL"})
                if (attributes.contains(attribute))
                    attributes[attribute] = moved(source, primitive, attribute, weights);
            primitive.erase("targets");
        }
        meshes[m].erase("weights");
    }
    if (meshes != source.list("meshes")) source.root["meshes"] = std::move(meshes);
}

}  // namespace knuckle
