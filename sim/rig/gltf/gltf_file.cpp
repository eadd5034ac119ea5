#include "sim/rig/gltf/gltf_file.h"

namespace knuckle {

namespace {

constexpr uint32_t GLB_MAGIC = 0x46546C67, GLB_VERSION = 2, CHUNK_JSON = 0x4E4F534A, CHUNK_BINARY = 0x004E4942;
constexpr size_t ALIGNMENT = 4;  // of chunks and accessors [bytes]

size_t aligned(size_t size)
{
    return (size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT;
}

void appendWord(std::string& text, size_t value)
{
    const auto word = static_cast<uint32_t>(value);
    text.append(reinterpret_cast<const char*>(&word), sizeof word);
}

}  // namespace

GltfFile::GltfFile()
{
    root["asset"] = {{"version", "2.0"}, {"generator", "knuckle"}};
}

size_t GltfFile::append(const char* list, GltfJson entry)
{
    if (!root.contains(list)) root[list] = GltfJson::array();
    root[list].push_back(std::move(entry));
    return root[list].size() - 1;
}

size_t GltfFile::appendOnce(const char* list, GltfJson entry)
{
    const auto [known,
                isNew] = entries_.try_emplace(list + entry.dump(-1, ' ', false, GltfJson::error_handler_t::replace));
    if (isNew) known->second = append(list, std::move(entry));
    return known->second;
}

void GltfFile::setBounds(size_t accessor, GltfJson low, GltfJson high)
{
    root["accessors"][accessor]["min"] = std::move(low);
    root["accessors"][accessor]["max"] = std::move(high);
}

size_t GltfFile::addView(const void* data, size_t size, int target, const std::string& kind)
{
    const std::string_view bytes(static_cast<const char*>(data), size);
    const std::string key = kind + std::to_string(target) + ' ' + std::to_string(std::hash<std::string_view>()(bytes));
    const auto [first, last] = viewsOf_.equal_range(key);
    for (auto known = first; known != last; ++known) {
        const GltfJson& view = root["bufferViews"][known->second];
        const std::string_view stored(buffer_.data() + view["byteOffset"].get<size_t>(), view["byteLength"]);
        if (stored == bytes) return known->second;
    }
    const size_t offset = buffer_.size();
    buffer_.append(bytes);
    buffer_.resize(aligned(buffer_.size()), '\0');
    GltfJson view{{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}};
    if (target != GLTF_NO_TARGET) view["target"] = target;
    const size_t index = append("bufferViews", std::move(view));
    viewsOf_.emplace(key, index);
    return index;
}

size_t GltfFile::addPng(const std::string& bytes, const std::string& name)
{
    const size_t view = addView(bytes.data(), bytes.size(), GLTF_NO_TARGET, "PNG");
    return appendOnce("images", {{"name", name}, {"bufferView", view}, {"mimeType", "image/png"}});
}

std::string GltfFile::bytes()
{
    if (!buffer_.empty()) root["buffers"] = GltfJson::array({GltfJson{{"byteLength", buffer_.size()}}});
    std::string json = root.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
    json.resize(aligned(json.size()), ' ');
    constexpr size_t HEADER = 12, CHUNK_HEADER = 8;
    const size_t chunks = CHUNK_HEADER + json.size() + (buffer_.empty() ? 0 : CHUNK_HEADER + buffer_.size());
    std::string glb;
    for (const size_t word : {size_t{GLB_MAGIC}, size_t{GLB_VERSION}, HEADER + chunks, json.size(), size_t{CHUNK_JSON}})
        appendWord(glb, word);
    glb += json;
    if (buffer_.empty()) return glb;
    appendWord(glb, buffer_.size());
    appendWord(glb, CHUNK_BINARY);
    return glb + buffer_;
}

}  // namespace knuckle
