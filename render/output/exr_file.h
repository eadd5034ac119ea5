#pragma once

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace knuckle {

/// A channel, a number for each pixel, top row first: its first one.
struct ExrChannel {
    const char* name;  ///< LAYER.CHANNEL
    std::variant<const float*, const uint32_t*> values;
    size_t stride = sizeof(float);  ///< From one pixel to the next [bytes].
};

/// The bytes of an OpenEXR file of 32-bit channels, packed by ZIP. @throws RunError.
std::string exrOf(uint32_t width, uint32_t height, const std::vector<ExrChannel>& channels);

}  // namespace knuckle
