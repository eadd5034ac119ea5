#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <vector>

#include "sim/base/json.h"
#include "sim/rig/gltf/component_types.h"

namespace knuckle {

using GltfJson = nlohmann::ordered_json;

// Wrapping modes and buffer targets of the glTF 2.0 specification.
inline constexpr int GLTF_CLAMP_TO_EDGE = 33071, GLTF_MIRRORED_REPEAT = 33648, GLTF_REPEAT = 10497;
inline constexpr int GLTF_ARRAY_BUFFER = 34962, GLTF_ELEMENT_ARRAY_BUFFER = 34963, GLTF_NO_TARGET = 0;

template <typename Vector>
GltfJson gltfArray(const Vector& v)
{
    GltfJson array = GltfJson::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) array.push_back(v[i]);
    return array;
}

template <typename Vector>
void appendTo(std::vector<float>& list, const Vector& v)
{
    list.insert(list.end(), v.data(), v.data() + v.size());
}

/// A binary glTF 2.0 file under construction: its JSON, and the buffer that it refers to.
class GltfFile {
public:
    GltfFile();

    /// Appends to one of the root's lists ("nodes", "meshes", ...). @returns its index.
    size_t append(const char* list, GltfJson entry);
    /// The same, but reuses an equal entry that this function has appended before.
    size_t appendOnce(const char* list, GltfJson entry);
    size_t count(const char* list) const { return root.contains(list) ? root[list].size() : 0; }

    /// An accessor to values that are stored once. @param type "SCALAR", "VEC3", ... of so many components.
    template <typename T>
    size_t addAccessor(const std::vector<T>& values, size_t components, int componentType, const char* type,
                       int target = GLTF_NO_TARGET)
    {
        const size_t view = addView(values.data(), values.size() * sizeof(T), target, type);
        return appendOnce("accessors", {{"bufferView", view},
                                        {"componentType", componentType},
                                        {"count", values.size() / components},
                                        {"type", type}});
    }
    /// Sets the least and greatest values of an accessor.
    void setBounds(size_t accessor, GltfJson low, GltfJson high);
    /// Appends a picture. @param bytes of a PNG file.
    size_t addPng(const std::string& bytes, const std::string& name);
    /// The whole file.
    std::string bytes();

    GltfJson root;

private:
    /// @param kind only views of the same kind share bytes.
    size_t addView(const void* data, size_t size, int target, const std::string& kind);

    std::string buffer_;
    std::map<std::string, size_t> entries_;       ///< Of appendOnce(), by list and text.
    std::multimap<std::string, size_t> viewsOf_;  ///< By their kind and the hash of what they view.
};

}  // namespace knuckle
