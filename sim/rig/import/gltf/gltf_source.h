#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "sim/base/json.h"

namespace knuckle {

/// A glTF file, text or binary, that can be changed in memory before it is read.
class GltfSource {
public:
    /// Name of the added data, a file that does not exist.
    static constexpr const char* ADDED_FILE = "knuckle-added-floats.bin";

    /// @returns nothing for a file that is not glTF, or whose JSON cannot be read.
    static std::unique_ptr<GltfSource> open(const std::string& path);

    GltfSource(const GltfSource&) = delete;
    GltfSource& operator=(const GltfSource&) = delete;

    nlohmann::json root;

    /// The entries of one of the root's lists; none if it has no such list.
    const nlohmann::json& list(const char* name) const;
    /// The bytes of a view. @throws InputError if its buffer is missing or too short.
    std::string_view viewBytes(size_t view);
    /// The bytes of a range, {"buffer", "byteOffset", "byteLength"}; valid until something is added. @throws InputError
    /// likewise.
    std::string_view rangeBytes(const nlohmann::json& range);
    /// Whether the file holds a buffer, or names another file for it.
    bool hasBuffer(size_t buffer) const;
    /// Appends a view of bytes. @returns its index.
    size_t addView(std::string_view bytes);
    /// Appends an accessor to floats. @param type "SCALAR", "VEC3", ... of so many components.
    size_t addFloats(const std::vector<float>& values, size_t components, const std::string& type);

    /// The whole file with its current JSON.
    std::string bytes() const;
    /// Contents of ADDED_FILE.
    const std::string& added() const { return added_; }

private:
    explicit GltfSource(std::string path) : path_(std::move(path)) {}
    std::string_view bufferBytes(size_t buffer);
    size_t append(const char* list, nlohmann::json entry);

    std::string path_, bytes_;
    size_t jsonStart_ = 0, jsonLength_ = 0;
    std::map<size_t, std::string> read_;  ///< Buffers that are not in the file itself.
    std::string added_;
    size_t addedBuffer_ = 0;  ///< Its index, once there are added data.
};

/// A name in a glTF, with escapes such as %20 decoded.
std::string decodedUri(std::string_view uri);

}  // namespace knuckle
