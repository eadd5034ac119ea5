#include "sim/rig/import/gltf/gltf_meshopt.h"

#include <fmt/format.h>
#include <meshoptimizer.h>

#include <array>
#include <optional>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

using Json = nlohmann::json;

constexpr std::array EXTENSIONS{"EXT_meshopt_compression", "KHR_meshopt_compression"};
constexpr size_t MOST_BYTES = size_t{1} << 29, MOST_STRIDE = 256;

const Json* extensionOf(const Json& entry, const char* name)
{
    const auto extensions = entry.find("extensions");
    if (extensions == entry.end() || !extensions->is_object()) return nullptr;
    const auto found = extensions->find(name);
    return found == extensions->end() ? nullptr : &*found;
}

/// Undoes the filter that was applied to elements before compression. @returns whether the filter is known.
bool undoFilter(const std::string& filter, std::string& bytes, size_t count, size_t stride)
{
    if (filter == "NONE") return true;
    if (filter == "OCTAHEDRAL" && (stride == 4 || stride == 8)) {
        meshopt_decodeFilterOct(bytes.data(), count, stride);
        return true;
    }
    if (filter == "QUATERNION" && stride == 8) {
        meshopt_decodeFilterQuat(bytes.data(), count, stride);
        return true;
    }
    if (filter == "EXPONENTIAL" && stride % 4 == 0) {
        meshopt_decodeFilterExp(bytes.data(), count, stride);
        return true;
    }
    return false;
}

/// Nothing for bytes that are not a meshopt stream.
std::optional<std::string> decoded(const Json& compression, std::string_view from)
{
    const auto count = compression.at("count").get<size_t>(), stride = compression.at("byteStride").get<size_t>();
    const auto mode = compression.at("mode").get<std::string>();
    if (stride == 0 || stride > MOST_STRIDE || count > MOST_BYTES / stride) return {};
    std::string bytes(count * stride, '\0');
    const auto* data = reinterpret_cast<const unsigned char*>(from.data());
    int error = -1;
    if (mode == "ATTRIBUTES" && stride % 4 == 0)
        error = meshopt_decodeVertexBuffer(bytes.data(), count, stride, data, from.size());
    if (mode == "TRIANGLES" && count % 3 == 0 && (stride == 2 || stride == 4))
        error = meshopt_decodeIndexBuffer(bytes.data(), count, stride, data, from.size());
    if (mode == "INDICES" && (stride == 2 || stride == 4))
        error = meshopt_decodeIndexSequence(bytes.data(), count, stride, data, from.size());
    if (error != 0 || !undoFilter(compression.value("filter", "NONE"), bytes, count, stride)) return {};
    return bytes;
}

/// Whether the bytes of a view are also stored uncompressed.
bool isPlain(const GltfSource& source, const Json& view, const char* extension)
{
    const auto buffer = view.at("buffer").get<size_t>();
    return source.hasBuffer(buffer) && extensionOf(source.list("buffers")[buffer], extension) == nullptr;
}

}  // namespace

void decodeMeshopt(GltfSource& source)
{
    for (size_t v = 0; v < source.list("bufferViews").size(); ++v) {
        const Json view = source.list("bufferViews")[v];
        for (const char* extension : EXTENSIONS) {
            const Json* compression = extensionOf(view, extension);
            if (compression == nullptr) continue;
            const std::optional<std::string> bytes = decoded(*compression, source.rangeBytes(*compression));
            if (!bytes && isPlain(source, view, extension)) continue;
            if (!bytes)
                throw InputError(
                    fmt::format("its buffer view {} is compressed with meshopt ({}) and damaged, or in a way that is "
                                "not read: export the model without that compression",
                                v, extension));
            Json plain = source.list("bufferViews")[source.addView(*bytes)];
            if (view.contains("target")) plain["target"] = view["target"];
            if (compression->at("mode") == "ATTRIBUTES") plain["byteStride"] = compression->at("byteStride");
            source.root["bufferViews"][v] = plain;
        }
    }
}

}  // namespace knuckle
