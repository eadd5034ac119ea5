#include "sim/rig/import/gltf/gltf_source.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "sim/base/base64.h"
#include "sim/base/errors.h"
#include "sim/base/lowercase.h"
#include "sim/rig/gltf/component_types.h"
#include "sim/rig/import/valid_text.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr size_t HEADER = 12, CHUNK_HEADER = 8;  // of a binary glTF [bytes]

uint32_t numberAt(const std::string& bytes, size_t place)
{
    uint32_t number = 0;
    std::memcpy(&number, bytes.data() + place, sizeof number);
    return number;
}

void setNumber(std::string& bytes, size_t place, size_t number)
{
    const auto value = static_cast<uint32_t>(number);
    std::memcpy(bytes.data() + place, &value, sizeof value);
}

std::string wholeFile(const fs::path& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::string decodedUri(std::string_view uri)
{
    std::string name;
    for (size_t i = 0; i < uri.size(); ++i) {
        unsigned code = 0;
        const char* digits = uri.data() + i + 1;
        const bool escaped = uri[i] == '%' && i + 2 < uri.size() &&
                             std::from_chars(digits, digits + 2, code, 16).ptr == digits + 2;
        name += escaped ? static_cast<char>(code) : uri[i];
        if (escaped) i += 2;
    }
    return name;
}

std::unique_ptr<GltfSource> GltfSource::open(const std::string& path)
{
    const std::string extension = lowercase(fs::path(path).extension().string());
    if (extension != ".glb" && extension != ".gltf") return {};
    std::unique_ptr<GltfSource> source(new GltfSource(path));
    source->bytes_ = wholeFile(path);
    source->jsonLength_ = source->bytes_.size();
    if (source->bytes_.starts_with("glTF")) {
        source->jsonStart_ = HEADER + CHUNK_HEADER;
        if (source->bytes_.size() < source->jsonStart_) return {};
        source->jsonLength_ = numberAt(source->bytes_, HEADER);
        if (source->jsonLength_ > source->bytes_.size() - source->jsonStart_) return {};
    }
    const std::string_view json = std::string_view(source->bytes_).substr(source->jsonStart_, source->jsonLength_);
    source->root = Json::parse(json, nullptr, false);
    if (source->root.is_discarded()) source->root = Json::parse(validText(json), nullptr, false);
    if (!source->root.is_object()) return {};
    return source;
}

const Json& GltfSource::list(const char* name) const
{
    static const Json NONE = Json::array();
    return root.contains(name) && root[name].is_array() ? root[name] : NONE;
}

bool GltfSource::hasBuffer(size_t buffer) const
{
    const Json& buffers = list("buffers");
    if (buffer >= buffers.size()) return false;
    return buffers[buffer].contains("uri") ||
           (buffer == 0 && jsonStart_ > 0 && jsonStart_ + jsonLength_ + CHUNK_HEADER < bytes_.size());
}

std::string_view GltfSource::bufferBytes(size_t buffer)
{
    if (!hasBuffer(buffer)) return {};
    if (!added_.empty() && buffer == addedBuffer_) return added_;
    const std::string uri = list("buffers")[buffer].value("uri", std::string());
    if (uri.empty()) return std::string_view(bytes_).substr(jsonStart_ + jsonLength_ + CHUNK_HEADER);
    const auto [known, isNew] = read_.try_emplace(buffer);
    if (!isNew) return known->second;
    const size_t comma = uri.find(',');
    if (uri.starts_with("data:")) {
        known->second = comma == std::string::npos ? "" : fromBase64(std::string_view(uri).substr(comma + 1));
        return known->second;
    }
    const fs::path folder = fs::path(path_).parent_path();
    std::error_code error;
    known->second = wholeFile(fs::is_regular_file(folder / uri, error) ? folder / uri : folder / decodedUri(uri));
    return known->second;
}

std::string_view GltfSource::rangeBytes(const Json& range)
{
    const std::string_view bytes = bufferBytes(range.at("buffer").get<size_t>());
    const auto offset = range.value("byteOffset", size_t{0}), length = range.value("byteLength", size_t{0});
    if (offset > bytes.size() || length > bytes.size() - offset)
        throw InputError(
            fmt::format("its numbers reach past the end of their buffer, which has {} bytes: it is cut off or "
                        "damaged; export the model again",
                        bytes.size()));
    return bytes.substr(offset, length);
}

std::string_view GltfSource::viewBytes(size_t view)
{
    const Json& views = list("bufferViews");
    if (view >= views.size())
        throw InputError(fmt::format("it names buffer view {}, it has {}: export the model again", view, views.size()));
    return rangeBytes(views[view]);
}

size_t GltfSource::append(const char* list, Json entry)
{
    if (!root.contains(list)) root[list] = Json::array();
    root[list].push_back(std::move(entry));
    return root[list].size() - 1;
}

size_t GltfSource::addView(std::string_view bytes)
{
    constexpr size_t ALIGNMENT = 4;
    if (added_.empty()) addedBuffer_ = append("buffers", {{"uri", ADDED_FILE}});
    const size_t offset = added_.size();
    added_ += bytes;
    added_.resize((added_.size() + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT);
    root["buffers"][addedBuffer_]["byteLength"] = added_.size();
    return append("bufferViews", {{"buffer", addedBuffer_}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
}

size_t GltfSource::addFloats(const std::vector<float>& values, size_t components, const std::string& type)
{
    const size_t view = addView({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float)});
    return append(
        "accessors",
        {{"bufferView", view}, {"componentType", GLTF_FLOAT}, {"count", values.size() / components}, {"type", type}});
}

std::string GltfSource::bytes() const
{
    std::string text = root.dump(-1, ' ', false, Json::error_handler_t::replace);
    const bool isBinary = jsonStart_ > 0;
    if (isBinary) text.resize((text.size() + 3) / 4 * 4, ' ');
    std::string whole = bytes_;
    whole.replace(jsonStart_, jsonLength_, text);
    if (isBinary) setNumber(whole, HEADER, text.size());
    if (isBinary) setNumber(whole, 8, whole.size());
    return whole;
}

}  // namespace knuckle
