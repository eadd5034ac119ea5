#include <gtest/gtest.h>
#include <meshoptimizer.h>

#include <algorithm>
#include <cmath>

#include "tests/rig/import/chain.h"
#include "tests/rig/import/edited_glb.h"
#include "tests/rig/import/surface_import.h"

namespace knuckle {
namespace {

using Json = nlohmann::json;
using test::EditedGlb;

constexpr int BYTE = 5120, SHORT = 5122, UNSIGNED_SHORT = 5123, UNSIGNED_INT = 5125;
constexpr const char* EXTENSION = "EXT_meshopt_compression";

/// Elements of one size, as bytes.
struct Elements {
    size_t stride = 0;
    std::string bytes;

    size_t count() const { return bytes.size() / stride; }
    const void* data() const { return bytes.data(); }
};

template <typename T>
Elements elements(const std::vector<T>& values, size_t components)
{
    return {components * sizeof(T), {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T)}};
}

std::string attributeStream(const Elements& of)
{
    std::vector<unsigned char> bytes(meshopt_encodeVertexBufferBound(of.count(), of.stride));
    bytes.resize(meshopt_encodeVertexBuffer(bytes.data(), bytes.size(), of.data(), of.count(), of.stride));
    return {bytes.begin(), bytes.end()};
}

std::string triangleStream(const std::vector<uint32_t>& corners)
{
    std::vector<unsigned char> bytes(meshopt_encodeIndexBufferBound(corners.size(), 1000));
    bytes.resize(meshopt_encodeIndexBuffer(bytes.data(), bytes.size(), corners.data(), corners.size()));
    return {bytes.begin(), bytes.end()};
}

std::string sequenceStream(const std::vector<uint32_t>& corners)
{
    std::vector<unsigned char> bytes(meshopt_encodeIndexSequenceBound(corners.size(), 1000));
    bytes.resize(meshopt_encodeIndexSequence(bytes.data(), bytes.size(), corners.data(), corners.size()));
    return {bytes.begin(), bytes.end()};
}

/// A chain whose numbers exist only compressed: the buffer for the uncompressed ones has no bytes.
class Meshopt : public test::SurfaceImport {
protected:
    static EditedGlb figure() { return EditedGlb(toGlb(paintedChain())); }
    static Json& accessorOf(EditedGlb& glb, const char* attribute)
    {
        return glb.root["accessors"].at(glb.primitive()["attributes"][attribute].get<size_t>());
    }
    static Json& turnsOfClip(EditedGlb& glb)
    {
        Json& clip = glb.root["animations"].at(0);
        for (const Json& channel : clip["channels"]) {
            Json& output = clip["samplers"].at(channel["sampler"].get<size_t>())["output"];
            const std::vector<float> turns = glb.floats(output.get<size_t>(), 4);
            if (channel["target"]["path"] == "rotation" && std::abs(turns.back()) < 0.999f)
                return glb.root["accessors"].at(output.get<size_t>());
        }
        throw std::out_of_range("no joint turns");
    }
    static std::vector<uint32_t> corners(EditedGlb& glb)
    {
        std::vector<uint32_t> list;
        for (const Triangle& t : chain("hips", 3, 0).triangles) list.insert(list.end(), t.begin(), t.end());
        glb.primitive()["indices"] = glb.add(list, 1, UNSIGNED_INT, "SCALAR");
        return list;
    }
    /// The numbers of an accessor of floats.
    static std::vector<float> floats(const EditedGlb& glb, const Json& accessor, size_t components)
    {
        const size_t index = static_cast<size_t>(&accessor - &glb.root["accessors"][0]);
        return glb.floats(index, components);
    }
    /// Makes an accessor refer to a stream of that many elements.
    static Json& compress(EditedGlb& glb, Json& accessor, const std::string& stream, size_t count, size_t stride,
                          const std::string& mode, const std::string& filter = "")
    {
        constexpr size_t ROOM = 100000;  // of a buffer without bytes
        if (glb.root["buffers"].size() == 1)
            glb.root["buffers"].push_back({{"byteLength", ROOM}, {"extensions", {{EXTENSION, {{"fallback", true}}}}}});
        glb.buffer.resize((glb.buffer.size() + 3) / 4 * 4, '\0');
        Json packed{{"buffer", 0},
                    {"byteOffset", glb.buffer.size()},
                    {"byteLength", stream.size()},
                    {"byteStride", stride},
                    {"count", count},
                    {"mode", mode}};
        if (!filter.empty()) packed["filter"] = filter;
        Json view{
            {"buffer", 1}, {"byteOffset", 0}, {"byteLength", count * stride}, {"extensions", {{EXTENSION, packed}}}};
        if (mode == "ATTRIBUTES") view["byteStride"] = stride;
        glb.buffer += stream;
        accessor["bufferView"] = glb.root["bufferViews"].size();
        accessor["byteOffset"] = 0;
        glb.root["extensionsRequired"] = {EXTENSION};
        return glb.root["bufferViews"].emplace_back(view);
    }
    static void expectAlike(const Model& model, const Model& wanted)
    {
        constexpr float CLOSE = 0.012f;  // of a normal in bytes
        ASSERT_EQ(model.vertices.size(), wanted.vertices.size());
        for (size_t v = 0; v < wanted.vertices.size(); ++v) {
            EXPECT_LT((model.vertices[v] - wanted.vertices[v]).norm(), 1e-3f) << v;
            EXPECT_LT((model.surface.vertices[v].normal - wanted.surface.vertices[v].normal).norm(), CLOSE) << v;
            EXPECT_EQ(model.skin[v].bones, wanted.skin[v].bones) << v;
        }
        // A stream of triangles may start each with another corner.
        ASSERT_EQ(model.triangles.size(), wanted.triangles.size());
        for (size_t t = 0; t < wanted.triangles.size(); ++t) {
            Triangle turned = model.triangles[t];
            std::rotate(turned.begin(), std::ranges::find(turned, wanted.triangles[t][0]), turned.end());
            EXPECT_EQ(turned, wanted.triangles[t]) << t;
        }
        ASSERT_EQ(model.clips.size(), 1u);
        EXPECT_LT((model.clips[0].poses.back().back() - wanted.clips[0].poses.back().back()).norm(), 1e-3f);
        EXPECT_GT((model.clips[0].poses.back().back() - wanted.bones.back().restPose).norm(), 0.1f);
        EXPECT_EQ(model.notes, wanted.notes);
    }
};

TEST_F(Meshopt, AttributesAreReadAndWhatFiltersDidToThem)
{
    EditedGlb plain = figure(), packed = figure();
    corners(plain);
    corners(packed);
    Json& places = accessorOf(packed, "POSITION");
    std::vector<float> values = floats(packed, places, 3);
    const size_t count = values.size() / 3;
    // For 2^E M: the exponent in the highest byte, M in the others. The library's own encoder has other arguments in
    // each version.
    constexpr int EXPONENT = -20;
    std::vector<uint32_t> exponential;
    for (const float value : values)
        exponential.push_back(static_cast<uint32_t>(EXPONENT) << 24 |
                              (static_cast<uint32_t>(std::lround(std::ldexp(value, -EXPONENT))) & 0xffffffu));
    compress(packed, places, attributeStream(elements(exponential, 3)), count, 12, "ATTRIBUTES", "EXPONENTIAL");

    Json& normals = accessorOf(packed, "NORMAL");
    values = floats(packed, normals, 3);
    std::vector<float> four;
    for (size_t v = 0; v < count; ++v)
        four.insert(four.end(), {values[3 * v], values[3 * v + 1], values[3 * v + 2], 0});
    std::vector<int8_t> octahedral(4 * count);
    meshopt_encodeFilterOct(octahedral.data(), count, 4, 8, four.data());
    normals["componentType"] = BYTE;
    normals["normalized"] = true;
    compress(packed, normals, attributeStream(elements(octahedral, 4)), count, 4, "ATTRIBUTES", "OCTAHEDRAL");

    Json& weights = accessorOf(packed, "WEIGHTS_0");
    compress(packed, weights, attributeStream(elements(floats(packed, weights, 4), 4)), count, 16, "ATTRIBUTES",
             "NONE");

    Json& turns = turnsOfClip(packed);
    values = floats(packed, turns, 4);
    std::vector<int16_t> quaternions(values.size());
    meshopt_encodeFilterQuat(quaternions.data(), values.size() / 4, 8, 16, values.data());
    turns["componentType"] = SHORT;
    turns["normalized"] = true;
    compress(packed, turns, attributeStream(elements(quaternions, 4)), values.size() / 4, 8, "ATTRIBUTES",
             "QUATERNION");
    expectAlike(import(packed), import(plain));
}

TEST_F(Meshopt, TrianglesAndSequencesOfIndicesAreRead)
{
    EditedGlb plain = figure();
    corners(plain);
    const Model wanted = import(plain);
    for (const bool isShort : {false, true}) {
        for (const std::string mode : {"TRIANGLES", "INDICES"}) {
            EditedGlb packed = figure();
            const std::vector<uint32_t> list = corners(packed);
            Json& indices = packed.root["accessors"].back();
            if (isShort) indices["componentType"] = UNSIGNED_SHORT;
            compress(packed, indices, mode == "TRIANGLES" ? triangleStream(list) : sequenceStream(list), list.size(),
                     isShort ? 2 : 4, mode);
            expectAlike(import(packed), wanted);
        }
    }
}

TEST_F(Meshopt, ADamagedStreamIsRefusedUnlessItsBytesAreThereAsWell)
{
    EditedGlb glb = figure();
    const std::vector<uint32_t> list = corners(glb);
    Json& indices = glb.root["accessors"].back();
    const size_t plainView = indices["bufferView"];
    const std::string stream = triangleStream(list);
    const size_t view = glb.root["bufferViews"].size();
    compress(glb, indices, stream, list.size(), 4, "TRIANGLES");
    EXPECT_EQ(refusal(glb), "");
    const std::string why = "small.glb: its buffer view " + std::to_string(view) +
                            " is compressed with meshopt (EXT_meshopt_compression) and damaged, or in a way that is "
                            "not read: export the model without that compression";
    Json& packed = glb.root["bufferViews"][view]["extensions"][EXTENSION];
    const Json whole = packed;
    for (const auto& [field, value] : {std::pair<const char*, Json>{"byteLength", stream.size() / 2},
                                       {"byteOffset", whole["byteOffset"].get<size_t>() + 1},
                                       {"count", list.size() + 300},
                                       {"byteStride", 3},
                                       {"byteStride", 0},
                                       {"count", 1000000000000},
                                       {"mode", "STRIPS"},
                                       {"filter", "SPIRAL"}}) {
        packed = whole;
        packed[field] = value;
        const std::string message = refusal(glb);
        EXPECT_TRUE(message.ends_with(why)) << field << ": " << message;
    }
    packed = whole;
    packed["byteLength"] = 10000000;
    EXPECT_NE(refusal(glb).find("past the end of their buffer"), std::string::npos) << refusal(glb);

    // A view that also has its bytes.
    packed = whole;
    packed["byteLength"] = stream.size() / 2;
    Json plain = glb.root["bufferViews"][plainView];
    plain["extensions"] = glb.root["bufferViews"][view]["extensions"];
    glb.root["bufferViews"][view] = plain;
    EXPECT_EQ(refusal(glb), "");
}

}  // namespace
}  // namespace knuckle
