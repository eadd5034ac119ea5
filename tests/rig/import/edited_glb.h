#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

#include "sim/base/json.h"
#include "sim/rig/gltf/glb.h"
#include "tests/rig/shapes.h"

namespace knuckle::test {

/// A binary glTF taken apart, to be changed and reassembled.
struct EditedGlb {
    nlohmann::json root;
    std::string buffer;

    explicit EditedGlb(const std::string& glb)
    {
        uint32_t length = 0;
        std::memcpy(&length, glb.data() + 12, sizeof length);
        root = nlohmann::json::parse(glb.substr(20, length));
        buffer = glb.substr(28 + length);
    }

    std::string bytes()
    {
        const auto word = [](size_t value) {
            const auto number = static_cast<uint32_t>(value);
            return std::string(reinterpret_cast<const char*>(&number), sizeof number);
        };
        buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
        root["buffers"][0]["byteLength"] = buffer.size();
        std::string json = root.dump();
        json.resize((json.size() + 3) / 4 * 4, ' ');
        return "glTF" + word(2) + word(28 + json.size() + buffer.size()) + word(json.size()) + "JSON" + json +
               word(buffer.size()) + std::string("BIN\0", 4) + buffer;
    }

    /// The numbers of an accessor of floats.
    std::vector<float> floats(size_t accessor, size_t components) const
    {
        const nlohmann::json& entry = root["accessors"].at(accessor);
        const nlohmann::json& view = root["bufferViews"].at(entry["bufferView"].get<size_t>());
        std::vector<float> values(entry["count"].get<size_t>() * components);
        std::memcpy(values.data(), buffer.data() + view["byteOffset"].get<size_t>(), values.size() * sizeof(float));
        return values;
    }

    /// Appends an accessor of numbers. @param stride 0: they are contiguous. @returns its index.
    template <typename T>
    size_t add(const std::vector<T>& values, size_t components, int componentType, const std::string& type,
               size_t stride = 0)
    {
        buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
        nlohmann::json view{{"buffer", 0}, {"byteOffset", buffer.size()}};
        const size_t size = components * sizeof(T), start = buffer.size();
        for (size_t i = 0; i < values.size(); i += components) {
            buffer.append(reinterpret_cast<const char*>(&values[i]), size);
            buffer.append(stride > size ? stride - size : 0, '\x55');
        }
        view["byteLength"] = buffer.size() - start;
        if (stride > 0) view["byteStride"] = stride;
        root["bufferViews"].push_back(view);
        root["accessors"].push_back({{"bufferView", root["bufferViews"].size() - 1},
                                     {"componentType", componentType},
                                     {"count", values.size() / components},
                                     {"type", type}});
        return root["accessors"].size() - 1;
    }

    /// Appends a mesh and a node with it.
    size_t addMesh(const std::string& name, const TriangleMesh& mesh)
    {
        std::vector<float> places;
        std::vector<uint32_t> corners;
        for (const Eigen::Vector3f& v : mesh.vertices) places.insert(places.end(), v.data(), v.data() + 3);
        for (const Triangle& t : mesh.triangles) corners.insert(corners.end(), t.begin(), t.end());
        const size_t positions = add(places, 3, 5126, "VEC3"), indices = add(corners, 1, 5125, "SCALAR");
        nlohmann::json primitive{{"attributes", {{"POSITION", positions}}}, {"indices", indices}};
        root["meshes"].push_back({{"primitives", nlohmann::json::array({primitive})}});
        root["nodes"].push_back({{"name", name}, {"mesh", root["meshes"].size() - 1}});
        return root["nodes"].size() - 1;
    }

    nlohmann::json& primitive(size_t mesh = 0) { return root["meshes"].at(mesh)["primitives"].at(0); }
};

}  // namespace knuckle::test
