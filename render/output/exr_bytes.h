#pragma once

#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>

#include <string>

namespace knuckle {

/// The bytes of an OpenEXR file. @param frame slices of all channels of the header. @throws RunError.
std::string exrBytes(const Imf::Header& header, const Imf::FrameBuffer& frame);

}  // namespace knuckle
