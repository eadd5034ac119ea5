#include <Imath/ImathBox.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>

#include "render/reader/decoders.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// The file's bytes as OpenEXR reads them.
class BytesStream : public Imf::IStream {
public:
    explicit BytesStream(std::string_view bytes) : Imf::IStream("picture"), bytes_(bytes) {}

    bool read(char* out, int count) override
    {
        const auto wanted = static_cast<uint64_t>(std::max(0, count));
        if (at_ > bytes_.size() || wanted > bytes_.size() - at_) throw std::runtime_error("it ends too early");
        std::memcpy(out, bytes_.data() + at_, wanted);
        at_ += wanted;
        return at_ < bytes_.size();
    }
    uint64_t tellg() override { return at_; }
    void seekg(uint64_t position) override { at_ = position; }

private:
    std::string_view bytes_;
    uint64_t at_ = 0;
};

/// Channels without a layer's name come first, then those of the first layer that has colours.
std::string layerOf(const Imf::ChannelList& channels)
{
    std::string found;
    bool any = false;
    for (auto channel = channels.begin(); channel != channels.end(); ++channel) {
        const std::string name = channel.name();
        const size_t dot = name.rfind('.');
        const std::string layer = dot == std::string::npos ? "" : name.substr(0, dot + 1);
        const std::string part = name.substr(layer.size());
        if (part != "R" && part != "G" && part != "B" && part != "Y") continue;
        if (layer.empty()) return "";
        if (!any) found = layer;
        any = true;
    }
    return found;
}

struct ExrChannels {
    std::array<std::string, 4> names;  ///< For red, green, blue, alpha; empty: there is none.
    bool grey = false;
    uint32_t bits = 16;
};

ExrChannels findChannels(const Imf::ChannelList& channels, const std::string& name)
{
    const std::string layer = layerOf(channels);
    const auto has = [&](const char* part) { return channels.findChannel(layer + part) != nullptr; };
    ExrChannels found;
    found.grey = has("Y") && !has("R") && !has("G") && !has("B");
    const std::array<const char*, 4> parts{found.grey ? "Y" : "R", found.grey ? "" : "G", found.grey ? "" : "B", "A"};
    bool any = false;
    for (size_t c = 0; c < 4; ++c) {
        if (parts[c][0] == '\0' || !has(parts[c])) continue;
        found.names[c] = layer + parts[c];
        const Imf::Channel* channel = channels.findChannel(found.names[c]);
        if (channel->xSampling != 1 || channel->ySampling != 1)
            failPicture(name, fmt::format("its channel {} is stored coarser than the picture; write all channels at "
                                          "full size",
                                          found.names[c]));
        if (channel->type != Imf::HALF) found.bits = 32;
        any = any || c < 3;
    }
    if (found.grey && (has("RY") || has("BY"))) failPicture(name, "it is luminance with chroma; write it as RGB");
    if (!any) failPicture(name, "it has no channel R, G, B or Y; write colours");
    return found;
}

/// The window that a viewer shows, and what is stored outside it: nothing of the file goes unseen.
Imath::Box2i shownWindow(const Imf::Header& header, const std::string& name)
{
    const Imath::Box2i& data = header.dataWindow();
    Imath::Box2i window = header.displayWindow();
    window.extendBy(data);
    const auto extent = [](int low, int high) { return static_cast<uint64_t>(int64_t{high} - low + 1); };
    checkPictureSize(extent(window.min.x, window.max.x), extent(window.min.y, window.max.y), name);
    return window;
}

void readChannels(Imf::InputFile& file, const ExrChannels& channels, const Imath::Box2i& window, Picture& picture)
{
    const Imath::Box2i data = file.header().dataWindow();
    Imf::FrameBuffer frame;
    const auto stride = ptrdiff_t{4 * sizeof(float)}, rowStride = stride * static_cast<ptrdiff_t>(picture.width);
    // OpenEXR adds a pixel's place times the strides: the pixel at 0, 0 may lie outside.
    const ptrdiff_t origin = -ptrdiff_t{window.min.x} * stride - ptrdiff_t{window.min.y} * rowStride;
    for (size_t c = 0; c < 4; ++c) {
        if (channels.names[c].empty()) continue;
        char* first = reinterpret_cast<char*>(picture.rgba.data() + c) + origin;
        frame.insert(channels.names[c],
                     Imf::Slice(Imf::FLOAT, first, static_cast<size_t>(stride), static_cast<size_t>(rowStride)));
    }
    file.setFrameBuffer(frame);
    file.readPixels(data.min.y, data.max.y);
}

/// Colours are linear and multiplied by alpha in the file already.
void finishPixels(const ExrChannels& channels, const Imath::Box2i& data, const Imath::Box2i& window, Picture& picture)
{
    for (int y = window.min.y; y <= window.max.y; ++y)
        for (int x = window.min.x; x <= window.max.x; ++x) {
            const auto column = static_cast<size_t>(x - window.min.x), row = static_cast<size_t>(y - window.min.y);
            float* pixel = &picture.rgba[(row * picture.width + column) * 4];
            if (channels.grey) pixel[1] = pixel[2] = pixel[0];
            for (size_t c = 0; c < 3; ++c) pixel[c] = encodeSrgb(pixel[c]);
            if (channels.names[3].empty()) pixel[3] = data.intersects(Imath::V2i(x, y)) ? 1.0f : 0.0f;
        }
}

}  // namespace

Picture decodeExr(std::string_view bytes, const std::string& name)
{
    Picture picture;
    try {
        BytesStream stream(bytes);
        Imf::InputFile file(stream, 0);
        if (!file.isComplete()) failPicture(name, "it is cut: parts of it were never written; write it anew");
        const ExrChannels channels = findChannels(file.header().channels(), name);
        const Imath::Box2i window = shownWindow(file.header(), name), data = file.header().dataWindow();
        picture.width = static_cast<uint32_t>(window.max.x - window.min.x + 1);
        picture.height = static_cast<uint32_t>(window.max.y - window.min.y + 1);
        picture.bitDepth = channels.bits;
        picture.hdr = true;
        picture.hasAlpha = !channels.names[3].empty() || data != window;
        picture.rgba.assign(picture.pixelCount() * 4, 0.0f);
        readChannels(file, channels, window, picture);
        finishPixels(channels, data, window, picture);
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        std::string reason = error.what();
        std::ranges::replace(reason, '\n', ' ');
        failPicture(name, reason + "; write it anew");
    }
    return picture;
}

}  // namespace knuckle
