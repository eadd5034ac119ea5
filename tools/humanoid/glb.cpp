#include "tools/humanoid/glb.h"

#include <Eigen/Geometry>
#include <cstring>
#include <nlohmann/json.hpp>
#include <vector>

namespace knuckle {

namespace {

using OrderedJson = nlohmann::ordered_json;

constexpr uint32_t GLB_MAGIC = 0x46546C67, GLB_VERSION = 2, CHUNK_JSON = 0x4E4F534A, CHUNK_BINARY = 0x004E4942;
// Component types and buffer targets of the glTF specification.
constexpr int UNSIGNED_BYTE = 5121, UNSIGNED_INT = 5125, UNSIGNED_SHORT = 5123, FLOAT = 5126;
constexpr int ARRAY_BUFFER = 34962, ELEMENT_ARRAY_BUFFER = 34963, NO_TARGET = 0;
constexpr size_t SHORT_INDICES = 65535;
constexpr size_t WEIGHTS = 4;  // of a glTF attribute

// Collects the binary chunk and the views and accessors into it.
class GltfBuffer {
public:
    template <typename T>
    int add(const std::vector<T>& values, size_t componentsPerElement, int componentType, const char* type, int target)
    {
        const size_t offset = bytes_.size(), size = values.size() * sizeof(T);
        bytes_.resize((offset + size + 3) / 4 * 4, '\0');
        std::memcpy(bytes_.data() + offset, values.data(), size);
        OrderedJson view = OrderedJson::object({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
        if (target != NO_TARGET) {
            view["target"] = target;
        }
        views_.push_back(view);
        accessors_.push_back(OrderedJson::object({{"bufferView", views_.size() - 1},
                                                  {"componentType", componentType},
                                                  {"count", values.size() / componentsPerElement},
                                                  {"type", type}}));
        return static_cast<int>(accessors_.size() - 1);
    }
    void bounds(int accessor, const OrderedJson& low, const OrderedJson& high)
    {
        accessors_[static_cast<size_t>(accessor)]["min"] = low;
        accessors_[static_cast<size_t>(accessor)]["max"] = high;
    }
    void finish(OrderedJson& root) const
    {
        root["bufferViews"] = views_;
        root["accessors"] = accessors_;
        root["buffers"] = OrderedJson::array({OrderedJson::object({{"byteLength", bytes_.size()}})});
    }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
    OrderedJson views_ = OrderedJson::array(), accessors_ = OrderedJson::array();
};

struct LocalPose {
    Eigen::Vector3f translation;
    Eigen::Quaternionf rotation;
};

LocalPose localPose(const Model& model, const std::vector<Eigen::Matrix4f>& pose, size_t bone)
{
    const int32_t parent = model.bones[bone].parent;
    const Eigen::Matrix4f local = parent < 0 ? pose[bone] : Eigen::Matrix4f(pose[parent].inverse() * pose[bone]);
    return {local.block<3, 1>(0, 3), Eigen::Quaternionf(local.topLeftCorner<3, 3>()).normalized()};
}

std::vector<Eigen::Matrix4f> restPoses(const Model& model)
{
    std::vector<Eigen::Matrix4f> poses;
    for (const Bone& bone : model.bones) {
        poses.push_back(bone.restPose);
    }
    return poses;
}

template <typename Vector>
OrderedJson toArray(const Vector& v)
{
    OrderedJson array = OrderedJson::array();
    for (Eigen::Index i = 0; i < v.size(); ++i) {
        array.push_back(v[i]);
    }
    return array;
}

template <typename Vector>
void append(std::vector<float>& list, const Vector& v)
{
    list.insert(list.end(), v.data(), v.data() + v.size());
}

// Bones are the nodes 0, 1, ...; the mesh's node comes after them.
OrderedJson nodesOf(const Model& model)
{
    OrderedJson nodes = OrderedJson::array();
    const std::vector<Eigen::Matrix4f> rest = restPoses(model);
    for (size_t b = 0; b < model.bones.size(); ++b) {
        const LocalPose pose = localPose(model, rest, b);
        OrderedJson node;
        node["name"] = model.bones[b].name;
        node["translation"] = toArray(pose.translation);
        if (!pose.rotation.coeffs().isApprox(Eigen::Quaternionf::Identity().coeffs())) {
            node["rotation"] = toArray(pose.rotation.coeffs());
        }
        OrderedJson children = OrderedJson::array();
        for (size_t c = b + 1; c < model.bones.size(); ++c) {
            if (model.bones[c].parent == static_cast<int32_t>(b)) {
                children.push_back(c);
            }
        }
        if (!children.empty()) {
            node["children"] = children;
        }
        nodes.push_back(node);
    }
    OrderedJson mesh;
    mesh["name"] = model.name;
    mesh["mesh"] = 0;
    if (!model.skin.empty()) {
        mesh["skin"] = 0;
    }
    nodes.push_back(mesh);
    return nodes;
}

OrderedJson meshOf(const Model& model, GltfBuffer& buffer)
{
    std::vector<float> positions, weights;
    std::vector<uint8_t> joints;
    std::vector<uint32_t> indices;
    Eigen::Vector3f low = model.vertices.front(), high = low;
    for (const Eigen::Vector3f& vertex : model.vertices) {
        append(positions, vertex);
        low = low.cwiseMin(vertex);
        high = high.cwiseMax(vertex);
    }
    for (const SkinWeights& skin : model.skin) {
        for (size_t i = 0; i < WEIGHTS; ++i) {
            joints.push_back(static_cast<uint8_t>(skin.bones[i]));
            weights.push_back(skin.weights[i]);
        }
    }
    for (const auto& triangle : model.triangles) {
        indices.insert(indices.end(), triangle.begin(), triangle.end());
    }
    OrderedJson primitive;
    primitive["attributes"]["POSITION"] = buffer.add(positions, 3, FLOAT, "VEC3", ARRAY_BUFFER);
    buffer.bounds(primitive["attributes"]["POSITION"], toArray(low), toArray(high));
    if (!model.skin.empty()) {
        primitive["attributes"]["JOINTS_0"] = buffer.add(joints, WEIGHTS, UNSIGNED_BYTE, "VEC4", ARRAY_BUFFER);
        primitive["attributes"]["WEIGHTS_0"] = buffer.add(weights, WEIGHTS, FLOAT, "VEC4", ARRAY_BUFFER);
    }
    if (model.vertices.size() <= SHORT_INDICES) {
        const std::vector<uint16_t> shortIndices(indices.begin(), indices.end());
        primitive["indices"] = buffer.add(shortIndices, 1, UNSIGNED_SHORT, "SCALAR", ELEMENT_ARRAY_BUFFER);
    } else {
        primitive["indices"] = buffer.add(indices, 1, UNSIGNED_INT, "SCALAR", ELEMENT_ARRAY_BUFFER);
    }
    return OrderedJson::object({{"name", model.name}, {"primitives", OrderedJson::array({primitive})}});
}

OrderedJson skinOf(const Model& model, GltfBuffer& buffer)
{
    std::vector<float> binds;
    OrderedJson joints = OrderedJson::array();
    for (size_t b = 0; b < model.bones.size(); ++b) {
        append(binds, Eigen::Matrix4f(model.bones[b].restPose.inverse()));
        joints.push_back(b);
    }
    const int accessor = buffer.add(binds, 16, FLOAT, "MAT4", NO_TARGET);
    return OrderedJson::object({{"joints", joints}, {"inverseBindMatrices", accessor}});
}

// Rotations of every bone, translations of the roots and of no other: bones keep their lengths.
OrderedJson clipOf(const Model& model, const Clip& clip, GltfBuffer& buffer)
{
    const std::vector<float> times(clip.keyTimes.begin(), clip.keyTimes.end());
    const int input = buffer.add(times, 1, FLOAT, "SCALAR", NO_TARGET);
    buffer.bounds(input, OrderedJson::array({times.front()}), OrderedJson::array({times.back()}));
    OrderedJson channels = OrderedJson::array(), samplers = OrderedJson::array();
    const auto addChannel = [&](size_t bone, const char* path, int output) {
        const OrderedJson target = OrderedJson::object({{"node", bone}, {"path", path}});
        channels.push_back(OrderedJson::object({{"sampler", samplers.size()}, {"target", target}}));
        samplers.push_back(OrderedJson::object({{"input", input}, {"output", output}}));
    };
    for (size_t b = 0; b < model.bones.size(); ++b) {
        std::vector<float> rotations, translations;
        Eigen::Quaternionf previous = Eigen::Quaternionf::Identity();
        for (const std::vector<Eigen::Matrix4f>& key : clip.poses) {
            LocalPose pose = localPose(model, key, b);
            if (previous.dot(pose.rotation) < 0.0f) {
                pose.rotation.coeffs() *= -1.0f;
            }
            previous = pose.rotation;
            append(rotations, pose.rotation.coeffs());
            append(translations, pose.translation);
        }
        addChannel(b, "rotation", buffer.add(rotations, 4, FLOAT, "VEC4", NO_TARGET));
        if (model.bones[b].parent < 0) {
            addChannel(b, "translation", buffer.add(translations, 3, FLOAT, "VEC3", NO_TARGET));
        }
    }
    return OrderedJson::object({{"name", clip.name}, {"channels", channels}, {"samplers", samplers}});
}

void appendWord(std::string& text, size_t value)
{
    const uint32_t word = static_cast<uint32_t>(value);
    text.append(reinterpret_cast<const char*>(&word), sizeof word);
}

}  // namespace

std::string toGlb(const Model& model)
{
    GltfBuffer buffer;
    OrderedJson root;
    root["asset"] = OrderedJson::object({{"version", "2.0"}, {"generator", "knuckle"}});
    OrderedJson roots = OrderedJson::array();
    for (size_t b = 0; b < model.bones.size(); ++b) {
        if (model.bones[b].parent < 0) {
            roots.push_back(b);
        }
    }
    roots.push_back(model.bones.size());
    root["scene"] = 0;
    root["scenes"] = OrderedJson::array({OrderedJson::object({{"nodes", roots}})});
    root["nodes"] = nodesOf(model);
    root["meshes"] = OrderedJson::array({meshOf(model, buffer)});
    if (!model.skin.empty()) {
        root["skins"] = OrderedJson::array({skinOf(model, buffer)});
    }
    OrderedJson animations = OrderedJson::array();
    for (const Clip& clip : model.clips) {
        animations.push_back(clipOf(model, clip, buffer));
    }
    if (!animations.empty()) {
        root["animations"] = animations;
    }
    buffer.finish(root);
    std::string json = root.dump();
    json.resize((json.size() + 3) / 4 * 4, ' ');
    std::string glb;
    constexpr size_t HEADERS = 12 + 8 + 8;
    for (const size_t word : {size_t{GLB_MAGIC}, size_t{GLB_VERSION}, HEADERS + json.size() + buffer.bytes().size(),
                              json.size(), size_t{CHUNK_JSON}}) {
        appendWord(glb, word);
    }
    glb += json;
    appendWord(glb, buffer.bytes().size());
    appendWord(glb, CHUNK_BINARY);
    return glb + buffer.bytes();
}

}  // namespace knuckle
