#include "sim/rig/import/gltf/gltf_floats.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <set>
#include <tuple>
#include <type_traits>

#include "sim/base/errors.h"
#include "sim/rig/gltf/component_types.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

constexpr size_t COUNT_LIMIT = 100000000;  // of numbers in an accessor

size_t sizeOf(int type)
{
    if (type == GLTF_BYTE || type == GLTF_UNSIGNED_BYTE) return 1;
    if (type == GLTF_SHORT || type == GLTF_UNSIGNED_SHORT) return 2;
    if (type == GLTF_UNSIGNED_INT || type == GLTF_FLOAT) return 4;
    throw InputError(
        fmt::format("it has numbers of a kind that glTF does not know ({}): export the model again", type));
}

size_t componentsOf(const std::string& type)
{
    if (type == "SCALAR") return 1;
    for (const size_t n : {size_t{2}, size_t{3}, size_t{4}})
        if (type == fmt::format("VEC{}", n)) return n;
    throw InputError(fmt::format("it has '{}' where vectors belong: export the model again", type));
}

template <typename T>
double numberAt(const char* place, bool isFraction)
{
    T number = 0;
    std::memcpy(&number, place, sizeof number);
    const auto value = static_cast<double>(number);
    if (!isFraction || std::is_same_v<T, float>) return value;
    return std::max(value / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

double numberAt(const char* place, int type, bool isFraction)
{
    switch (type) {
        case GLTF_BYTE: return numberAt<int8_t>(place, isFraction);
        case GLTF_UNSIGNED_BYTE: return numberAt<uint8_t>(place, isFraction);
        case GLTF_SHORT: return numberAt<int16_t>(place, isFraction);
        case GLTF_UNSIGNED_SHORT: return numberAt<uint16_t>(place, isFraction);
        case GLTF_UNSIGNED_INT: return numberAt<uint32_t>(place, isFraction);
        default: return numberAt<float>(place, isFraction);
    }
}

/// Numbers in a view, element by element.
struct Elements {
    std::string_view bytes;
    int type = GLTF_FLOAT;
    size_t components = 1, stride = 0;

    double at(size_t element, size_t component, bool isFraction) const
    {
        return numberAt(bytes.data() + element * stride + component * sizeOf(type), type, isFraction);
    }
};

/// @param where has a "bufferView" and perhaps a "byteOffset". @throws InputError if it ends before `count`.
Elements elementsOf(GltfSource& source, const Json& where, int type, size_t components, size_t count)
{
    const auto view = where.at("bufferView").get<size_t>();
    Elements elements{source.viewBytes(view), type, components, 0};
    const size_t size = components * sizeOf(type), offset = where.value("byteOffset", size_t{0});
    const size_t stride = source.list("bufferViews")[view].value("byteStride", size_t{0});
    elements.stride = stride > 0 ? stride : size;
    const size_t there = elements.bytes.size() - std::min(offset, elements.bytes.size());
    if (count > 0 && (size > there || (count - 1) > (there - size) / elements.stride))
        throw InputError(fmt::format("its numbers reach past the end of buffer view {}: it is cut off or damaged; "
                                     "export the model again",
                                     view));
    elements.bytes.remove_prefix(elements.bytes.size() - there);
    return elements;
}

void replaceSparse(GltfSource& source, const Json& sparse, int type, bool isFraction, GltfFloats& floats)
{
    const auto count = sparse.at("count").get<size_t>();
    const Json &where = sparse.at("indices"), &what = sparse.at("values");
    const Elements indices = elementsOf(source, where, where.at("componentType").get<int>(), 1, count);
    const Elements values = elementsOf(source, what, type, floats.components, count);
    for (size_t i = 0; i < count; ++i) {
        const auto element = static_cast<size_t>(std::max(indices.at(i, 0, false), 0.0));
        if (element >= floats.values.size() / floats.components)
            throw InputError("a sparse accessor replaces what is not there: export the model again");
        for (size_t c = 0; c < floats.components; ++c)
            floats.values[element * floats.components + c] = static_cast<float>(values.at(i, c, isFraction));
    }
}

/// Replaces references to accessors of integers by references to accessors of floats.
class Converter {
public:
    explicit Converter(GltfSource& source) : source_(source) {}

    void convert(Json& reference, bool isFraction)
    {
        const auto accessor = reference.get<size_t>();
        const Json& accessors = source_.list("accessors");
        if (accessor >= accessors.size() || accessors[accessor].value("componentType", GLTF_FLOAT) == GLTF_FLOAT)
            return;
        const auto key = std::tuple{accessor, isFraction};
        if (!known_.contains(key)) {
            const GltfFloats floats = readFloats(source_, accessor, isFraction);
            known_[key] = source_.addFloats(floats.values, floats.components, floats.type);
        }
        reference = known_[key];
    }

    void convertAttributes(Json& attributes)
    {
        for (auto& [name, reference] : attributes.items()) {
            const std::string kind = name.substr(0, name.find('_'));
            // These are fractions of 1, even if the file forgets to say so.
            const bool isFraction = kind == "WEIGHTS" || kind == "COLOR";
            if (isFraction || kind == "POSITION" || kind == "NORMAL" || kind == "TANGENT" || kind == "TEXCOORD")
                convert(reference, isFraction);
        }
    }

private:
    GltfSource& source_;
    std::map<std::tuple<size_t, bool>, size_t> known_;
};

}  // namespace

GltfFloats readFloats(GltfSource& source, size_t index, bool isFraction)
{
    const Json accessor = source.list("accessors").at(index);
    GltfFloats floats;
    floats.type = accessor.at("type").get<std::string>();
    floats.components = componentsOf(floats.type);
    const auto count = accessor.at("count").get<size_t>();
    const int type = accessor.at("componentType").get<int>();
    if (count > COUNT_LIMIT / floats.components)
        throw InputError(fmt::format("it has {} vectors in one accessor: simplify it", count));
    const bool fraction = isFraction || accessor.value("normalized", false);
    if (accessor.contains("bufferView")) {
        const Elements elements = elementsOf(source, accessor, type, floats.components, count);
        floats.values.reserve(count * floats.components);
        for (size_t i = 0; i < count; ++i)
            for (size_t c = 0; c < floats.components; ++c)
                floats.values.push_back(static_cast<float>(elements.at(i, c, fraction)));
    }
    floats.values.resize(count * floats.components, 0.0f);
    if (accessor.contains("sparse")) replaceSparse(source, accessor.at("sparse"), type, fraction, floats);
    return floats;
}

void supplyFloats(GltfSource& source)
{
    Converter converter(source);
    // Changes copies: adding accessors moves the root's entries.
    Json meshes = source.list("meshes"), animations = source.list("animations");
    const Json before = Json::array({meshes, animations});
    for (Json& mesh : meshes) {
        for (Json& primitive : mesh.at("primitives")) {
            // Compressed data are elsewhere.
            if (primitive.value("extensions", Json::object()).contains("KHR_draco_mesh_compression")) continue;
            if (primitive.contains("attributes")) converter.convertAttributes(primitive["attributes"]);
            if (!primitive.contains("targets")) continue;
            for (Json& target : primitive["targets"]) converter.convertAttributes(target);
        }
    }
    for (Json& animation : animations) {
        std::set<size_t> turns;  // samplers of rotations
        for (const Json& channel : animation.value("channels", Json::array()))
            if (channel.at("target").value("path", std::string()) == "rotation")
                turns.insert(channel.at("sampler").get<size_t>());
        Json& samplers = animation["samplers"];
        for (size_t s = 0; s < samplers.size(); ++s) converter.convert(samplers[s].at("output"), turns.contains(s));
    }
    if (before[0] != meshes) source.root["meshes"] = std::move(meshes);
    if (before[1] != animations) source.root["animations"] = std::move(animations);
}

void supplyBindMatrices(GltfSource& source)
{
    Json skins = source.list("skins");
    constexpr size_t NUMBERS = 16, DIAGONAL = 5;
    for (Json& skin : skins) {
        const size_t joints = skin.at("joints").size();
        if (skin.contains("inverseBindMatrices")) {
            const auto accessor = skin["inverseBindMatrices"].get<size_t>();
            const Json& accessors = source.list("accessors");
            if (accessor >= accessors.size() || accessors[accessor].value("count", size_t{0}) < joints)
                throw InputError(
                    fmt::format("a skin of {} bones has fewer bind matrices: export the model again", joints));
            continue;
        }
        std::vector<float> identities(NUMBERS * joints, 0.0f);
        for (size_t i = 0; i < identities.size(); ++i) identities[i] = i % NUMBERS % DIAGONAL == 0 ? 1.0f : 0.0f;
        if (joints > 0) skin["inverseBindMatrices"] = source.addFloats(identities, NUMBERS, "MAT4");
    }
    if (skins != source.list("skins")) source.root["skins"] = std::move(skins);
}

}  // namespace knuckle
