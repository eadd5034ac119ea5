#include <fmt/format.h>

#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

class PngSink : public FrameSink {
public:
    explicit PngSink(std::string folder) : folder_(std::move(folder)) {}
    void write(Image image, uint64_t number) override
    {
        writer_.push([this, number, image = std::move(image)] {
            writePng(fmt::format("{}/frame_{:04}.png", folder_, number), image);
        });
    }
    void finish() override { writer_.drain(); }

private:
    const std::string folder_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> pngSink(const std::string& folder)
{
    requireWritableFolder(folder);
    return std::make_unique<PngSink>(folder);
}

}  // namespace knuckle
