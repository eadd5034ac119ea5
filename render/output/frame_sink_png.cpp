#include <fmt/format.h>

#include "render/output/frame_queue.h"
#include "render/output/frame_sink.h"
#include "render/output/temporary_file.h"

namespace knuckle {

namespace {

class PngSink : public FrameSink {
public:
    explicit PngSink(std::string folder)
        : queue_([folder = std::move(folder)](const Image& image, uint64_t number) {
              writePng(fmt::format("{}/frame_{:04}.png", folder, number), image);
          })
    {
    }
    void write(Image image, uint64_t number) override { queue_.push(std::move(image), number); }
    void finish() override { queue_.drain(); }

private:
    FrameQueue queue_;
};

}  // namespace

std::unique_ptr<FrameSink> pngSink(const std::string& folder)
{
    requireWritableFolder(folder);
    return std::make_unique<PngSink>(folder);
}

}  // namespace knuckle
