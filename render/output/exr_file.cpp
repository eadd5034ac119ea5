#include "render/output/exr_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>

#include <algorithm>

#include "render/output/exr_bytes.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Grows in memory.
class BytesOut : public Imf::OStream {
public:
    BytesOut() : Imf::OStream("picture") {}
    void write(const char* data, int count) override
    {
        const auto size = static_cast<size_t>(count);
        if (bytes.size() < at_ + size) bytes.resize(at_ + size);
        std::copy_n(data, size, bytes.begin() + static_cast<std::ptrdiff_t>(at_));
        at_ += size;
    }
    uint64_t tellp() override { return at_; }
    void seekp(uint64_t position) override { at_ = position; }

    std::string bytes;

private:
    uint64_t at_ = 0;
};

}  // namespace

std::string exrBytes(const Imf::Header& header, const Imf::FrameBuffer& frame)
{
    BytesOut out;
    try {
        Imf::OutputFile file(out, header, 0);
        file.setFrameBuffer(frame);
        file.writePixels(header.dataWindow().max.y + 1);
    } catch (const std::exception& error) {
        throw RunError(std::string("a picture cannot be encoded: ") + error.what());
    }
    return out.bytes;
}

std::string exrOf(uint32_t width, uint32_t height, const std::vector<ExrChannel>& channels)
{
    Imf::Header header(static_cast<int>(width), static_cast<int>(height));
    header.compression() = Imf::ZIP_COMPRESSION;
    Imf::FrameBuffer frame;
    for (const ExrChannel& channel : channels) {
        const Imf::PixelType type = channel.values.index() == 0 ? Imf::FLOAT : Imf::UINT;
        const void* first = std::visit([](auto values) -> const void* { return values; }, channel.values);
        header.channels().insert(channel.name, Imf::Channel(type));
        // What is written from is not changed.
        frame.insert(channel.name, Imf::Slice(type, static_cast<char*>(const_cast<void*>(first)), channel.stride,
                                              channel.stride * width));
    }
    return exrBytes(header, frame);
}

}  // namespace knuckle
