#include <fmt/format.h>

#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

class PngSink : public FrameSink {
public:
    PngSink(std::string folder, PictureKeep* keep) : folder_(std::move(folder)), keep_(keep) {}
    bool wants(uint64_t number) override { return keep_ == nullptr || !keep_->has(number); }
    void write(Image image, uint64_t number) override
    {
        writer_.push([this, number, image = std::move(image)] {
            const std::string bytes = pngOf(image);
            writeFile(fmt::format("{}/frame_{:04}.png", folder_, number), bytes);
            if (keep_ != nullptr) keep_->written(number, bytes);
        });
    }
    void flush() override { writer_.drain(); }
    void finish() override { writer_.drain(); }

private:
    const std::string folder_;
    PictureKeep* const keep_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> pngSink(const std::string& folder, PictureKeep* keep)
{
    requireWritableFolder(folder);
    return std::make_unique<PngSink>(folder, keep);
}

}  // namespace knuckle
