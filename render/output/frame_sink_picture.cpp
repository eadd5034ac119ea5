#include <utility>

#include "render/output/deep_pictures.h"
#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

class PictureSink : public FrameSink {
public:
    PictureSink(FrameNames names, PictureKeep* keep, int quality, uint32_t depth)
        : names_(std::move(names)), keep_(keep), quality_(quality), isDeep_(depth == 16)
    {
    }
    bool wants(uint64_t number) override { return keep_ == nullptr || !keep_->has(number); }
    void write(Image image, uint64_t number) override
    {
        writer_.push([this, number, image = std::move(image)] {
            const std::string bytes = bytesOf(image);
            writeFile(names_.path(number), bytes);
            if (keep_ != nullptr) keep_->written(number, bytes);
        });
    }
    void flush() override { writer_.drain(); }
    void finish() override { writer_.drain(); }

private:
    std::string bytesOf(const Image& image) const
    {
        if (names_.areJpeg()) return jpegOf(image, quality_);
        if (names_.areExr()) return exrOf(image);
        return isDeep_ ? deepPngOf(image) : pngOf(image);
    }

    const FrameNames names_;
    PictureKeep* const keep_;
    const int quality_;
    const bool isDeep_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> pictureSink(const FrameNames& names, PictureKeep* keep, int quality, uint32_t depth)
{
    requireWritableFolder(names.folder);
    return std::make_unique<PictureSink>(names, keep, quality, depth);
}

}  // namespace knuckle
