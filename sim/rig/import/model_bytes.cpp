#include "sim/rig/import/model_bytes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

namespace knuckle {

namespace {

// One list of fields for both directions: `Archive` writes or reads each.
class Writer {
public:
    std::vector<uint8_t> bytes;

    template <typename T>
    void plain(const T& value)
    {
        const auto* begin = reinterpret_cast<const uint8_t*>(&value);
        bytes.insert(bytes.end(), begin, begin + sizeof value);
    }
    template <typename T>
    void block(const std::vector<T>& values)
    {
        plain<uint64_t>(values.size());
        const auto* begin = reinterpret_cast<const uint8_t*>(values.data());
        bytes.insert(bytes.end(), begin, begin + values.size() * sizeof(T));
    }
    template <typename T, typename Visit>
    void list(const std::vector<T>& values, Visit visit)
    {
        plain<uint64_t>(values.size());
        for (const T& value : values) {
            visit(value);
        }
    }
    void text(const std::string& value)
    {
        plain<uint64_t>(value.size());
        bytes.insert(bytes.end(), value.begin(), value.end());
    }
};

class Reader {
public:
    explicit Reader(std::span<const uint8_t> bytes) : bytes_(bytes) {}
    bool good = true;

    bool atEnd() const { return bytes_.empty(); }

    template <typename T>
    void plain(T& value)
    {
        take(&value, sizeof value);
    }
    template <typename T>
    void block(std::vector<T>& values)
    {
        values.resize(count(sizeof(T)));
        take(values.data(), values.size() * sizeof(T));
    }
    template <typename T, typename Visit>
    void list(std::vector<T>& values, Visit visit)
    {
        values.resize(count(1));
        for (T& value : values) {
            visit(value);
        }
    }
    void text(std::string& value)
    {
        value.resize(count(1));
        take(value.data(), value.size());
    }

private:
    // The number of elements that follow; none if there cannot be so many.
    size_t count(size_t elementSize)
    {
        uint64_t n = 0;
        plain(n);
        good = good && n <= bytes_.size() / elementSize;
        return good ? n : 0;
    }
    void take(void* target, size_t size)
    {
        good = good && size <= bytes_.size();
        if (good && size > 0) {
            std::memcpy(target, bytes_.data(), size);
            bytes_ = bytes_.subspan(size);
        }
    }
    std::span<const uint8_t> bytes_;
};

template <typename Archive, typename Any>
void visitModel(Archive& archive, Any& model)
{
    archive.text(model.name);
    archive.block(model.vertices);
    archive.block(model.triangles);
    archive.block(model.skin);
    archive.block(model.surface.vertices);
    archive.list(model.surface.materials, [&](auto& material) {
        archive.text(material.name);
        archive.plain(material.color);
        archive.plain(material.texture);
        archive.plain(material.twoSided);
        archive.plain(material.alphaCutoff);
        archive.plain(material.wrap);
        archive.plain(material.roughness);
        archive.plain(material.metalness);
        archive.plain(material.normals);
        archive.plain(material.roughnesses);
        archive.plain(material.normalScale);
    });
    archive.list(model.surface.textures, [&](auto& picture) {
        archive.plain(picture.width);
        archive.plain(picture.height);
        archive.block(picture.rgba);
    });
    archive.list(model.surface.missing, [&](auto& what) { archive.text(what); });
    archive.list(model.surface.notes, [&](auto& note) { archive.text(note); });
    archive.list(model.bones, [&](auto& bone) {
        archive.text(bone.name);
        archive.plain(bone.parent);
        archive.plain(bone.restPose);
    });
    archive.plain(model.isSplit);
    archive.list(model.clips, [&](auto& clip) {
        archive.text(clip.name);
        archive.plain(clip.duration);
        archive.block(clip.keyTimes);
        archive.list(clip.poses, [&](auto& pose) { archive.block(pose); });
        archive.list(clip.notes, [&](auto& note) { archive.text(note); });
    });
    archive.list(model.unusableClips, [&](auto& clip) {
        archive.text(clip.name);
        archive.text(clip.why);
    });
    archive.text(model.poseFrom);
    archive.list(model.notes, [&](auto& note) { archive.text(note); });
}

bool valid(const ModelSurface& surface, size_t vertexCount)
{
    bool good = surface.vertices.empty() || surface.vertices.size() == vertexCount;
    for (const SurfaceVertex& vertex : surface.vertices) {
        good = good && vertex.normal.allFinite() && vertex.uv.allFinite() && vertex.color.allFinite() &&
               vertex.material < surface.materials.size();
    }
    for (const SkinMaterial& material : surface.materials) {
        good = good && material.color.allFinite() && std::isfinite(material.alphaCutoff) &&
               material.roughness <= 1.0f && material.metalness <= 1.0f &&
               std::ranges::max(material.wrap) <= TextureWrap::Clamp && material.normalScale >= 0.0f &&
               material.normalScale <= 10.0f;
        for (const uint32_t texture : {material.texture, material.normals, material.roughnesses})
            good = good && (texture == NO_INDEX || texture < surface.textures.size());
    }
    for (const TexturePicture& picture : surface.textures) {
        good = good && picture.width > 0 && picture.height > 0 && picture.width <= TEXTURE_SIDE &&
               picture.height <= TEXTURE_SIDE && picture.rgba.size() == size_t{4} * picture.width * picture.height;
    }
    return good;
}

bool valid(const Model& model)
{
    const auto finite = [](const auto& m) { return m.allFinite(); };
    const auto allFinite = [&](const auto& list) { return std::all_of(list.begin(), list.end(), finite); };
    bool good = valid(model.surface, model.vertices.size()) && allFinite(model.vertices) &&
                (model.skin.empty() || model.skin.size() == model.vertices.size());
    for (const auto& triangle : model.triangles) {
        good = good && *std::max_element(triangle.begin(), triangle.end()) < model.vertices.size();
    }
    for (const SkinWeights& skin : model.skin) {
        for (size_t i = 0; i < skin.bones.size(); ++i) {
            good = good && skin.bones[i] < model.bones.size() && skin.weights[i] >= 0.0f && skin.weights[i] <= 1.0f;
        }
    }
    for (size_t b = 0; b < model.bones.size(); ++b) {
        good = good && model.bones[b].parent < static_cast<int32_t>(b) && model.bones[b].parent >= -1 &&
               finite(model.bones[b].restPose);
    }
    for (const Clip& clip : model.clips) {
        good = good && clip.poses.size() == clip.keyTimes.size();
        for (const auto& pose : clip.poses) {
            good = good && pose.size() == model.bones.size() && allFinite(pose);
        }
    }
    return good;
}

}  // namespace

std::vector<uint8_t> toBytes(const Model& model)
{
    Writer writer;
    visitModel(writer, model);
    return std::move(writer.bytes);
}

bool fromBytes(std::span<const uint8_t> bytes, Model& model)
{
    Reader reader(bytes);
    visitModel(reader, model);
    return reader.good && reader.atEnd() && valid(model);
}

}  // namespace knuckle
