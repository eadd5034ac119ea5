#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace knuckle {

using Defines = std::vector<std::pair<std::string, std::string>>;

/// GLSL text with its includes resolved, and the original file and line of each of its lines.
struct ResolvedShader {
    std::string text;
    struct Origin {
        std::string file;
        int line = 0;
    };
    std::vector<Origin> origins;  ///< One per line of text, in order.

    /// Rewrites the line numbers of a driver's log ("0:17(3): error") to file:line of the real file.
    std::string translate(const std::string& log) const;
};

/// Source of shaders: embedded in the binary, or a folder on disk that overrides them for development.
class ShaderSource {
public:
    explicit ShaderSource(std::string overrideFolder = {}) : folder_(std::move(overrideFolder)) {}

    /// Text of `path` (below shaders/) under `#version 430 core` and the defines, each `#include "path"` once.
    /// @throws DeviceError for a missing file.
    ResolvedShader resolve(const std::string& path, const Defines& defines = {}) const;
    /// Of the text of all shaders.
    uint64_t hash() const;

private:
    std::string read(const std::string& path) const;
    void append(const std::string& path, ResolvedShader& out, std::vector<std::string>& seen) const;
    std::string folder_;
};

}  // namespace knuckle
