#pragma once

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace knuckle {

/// The bytes of an OpenEXR file. @param frame slices of all channels of the header. @throws RunError.
std::string exrBytes(const Imf::Header& header, const Imf::FrameBuffer& frame);

/// A channel, a number for each pixel, top row first: its first one.
struct ExrChannel {
    const char* name;  ///< LAYER.CHANNEL
    std::variant<const float*, const uint32_t*> values;
    size_t stride = sizeof(float);  ///< From one pixel to the next [bytes].
};

/// The bytes of an OpenEXR file of 32-bit channels, packed by ZIP. @throws RunError.
std::string exrOf(uint32_t width, uint32_t height, const std::vector<ExrChannel>& channels);

}  // namespace knuckle
