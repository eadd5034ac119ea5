#include <utility>

#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

class PictureSink : public FrameSink {
public:
    PictureSink(FrameNames names, PictureKeep* keep, int quality)
        : names_(std::move(names)), keep_(keep), quality_(quality)
    {
    }
    bool wants(uint64_t number) override { return keep_ == nullptr || !keep_->has(number); }
    void write(Image image, uint64_t number) override
    {
        writer_.push([this, number, image = std::move(image)] {
            const std::string bytes = names_.areJpeg() ? jpegOf(image, quality_) : pngOf(image);
            writeFile(names_.path(number), bytes);
            if (keep_ != nullptr) keep_->written(number, bytes);
        });
    }
    void flush() override { writer_.drain(); }
    void finish() override { writer_.drain(); }

private:
    const FrameNames names_;
    PictureKeep* const keep_;
    const int quality_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> pictureSink(const FrameNames& names, PictureKeep* keep, int quality)
{
    requireWritableFolder(names.folder);
    return std::make_unique<PictureSink>(names, keep, quality);
}

}  // namespace knuckle
