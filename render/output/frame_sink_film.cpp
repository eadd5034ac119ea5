#include <fmt/format.h>

#include <algorithm>

#include "render/output/ffmpeg.h"
#include "render/output/film_segments.h"
#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

std::string containerOf(const std::string& path)
{
    const std::string ending = endingOf(path);
    return ending == ".mkv" ? "matroska" : ending == ".mov" ? "mov" : "mp4";
}

void checkSize(const Image& image, const FilmFormat& format, uint64_t number)
{
    if (image.width != format.width || image.height != format.height)
        throw RunError(fmt::format("frame {} is {}x{}, but the film is {}x{}", number, image.width, image.height,
                                   format.width, format.height));
}

/// Into a stream, in one piece.
class StreamSink : public FrameSink {
public:
    StreamSink(const std::string& ffmpeg, const std::string& path, FilmFormat format)
        : format_(std::move(format)), file_(path),
          ffmpeg_(ffmpeg, arguments(format_), file_.descriptor(), shownPath(path))
    {
    }

    void write(Image image, uint64_t number) override
    {
        checkSize(image, format_, number);
        writer_.push([this, image = std::move(image)] { ffmpeg_.write(image.rgb.data(), image.rgb.size()); });
    }
    void flush() override { writer_.drain(); }
    void finish() override
    {
        writer_.drain();
        ffmpeg_.finish();
        file_.commit();
    }

private:
    static std::vector<std::string> arguments(const FilmFormat& format)
    {
        std::vector<std::string> list = encoderArguments(format);
        list.insert(list.end(), {"-f", format.container});
        // A stream has no way back.
        if (format.container != "matroska")
            list.insert(list.end(), {"-movflags", "frag_keyframe+empty_moov+default_base_moof"});
        list.emplace_back("pipe:1");
        return list;
    }

    FilmFormat format_;
    // The order matters: first the thread ends, then ffmpeg is stopped, then its output is closed.
    OutputFile file_;
    Ffmpeg ffmpeg_;
    TaskThread writer_{MAX_UNWRITTEN};
};

class FilmSink : public FrameSink {
public:
    FilmSink(const std::string& ffmpeg, const std::string& path, const FilmFormat& format, const FilmPart& part)
        : format_(format), first_(part.first), last_(part.last), file_(path),
          own_(part.keep != nullptr ? nullptr : temporaryKeep(path)),
          segments_(ffmpeg, format, shownPath(path), part.keep != nullptr ? *part.keep : *own_)
    {
    }

    bool wants(uint64_t number) override { return own_ != nullptr || segments_.wants(number - first_); }
    void write(Image image, uint64_t number) override
    {
        checkSize(image, format_, number);
        if (first_ == 0) first_ = number;
        last_ = std::max(last_, number);
        writer_.push([this, index = number - first_, image = std::move(image)] { segments_.write(index, image.rgb); });
    }
    void flush() override { writer_.drain(); }
    void finish() override
    {
        writer_.drain();
        segments_.finish(last_ - first_ + 1, file_.temporaryName());
        file_.commit();
        own_.reset();
    }

private:
    FilmFormat format_;
    uint64_t first_, last_;
    // The order matters: first the thread ends, then ffmpeg is stopped, then its outputs are removed.
    OutputFile file_;
    std::unique_ptr<FilmKeep> own_;
    FilmSegments segments_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> filmSink(const std::string& path, const FilmFormat& wanted, const FilmPart& part)
{
    const bool stream = OutputPlace::of(path).kind == OutputPlace::Kind::Stream;
    if (!stream && !std::ranges::count(FILM_ENDINGS, endingOf(path)))
        throw InputError(fmt::format("film {}: its kind is not known; name it .mp4, .mov or .mkv", shownPath(path)));
    const std::string ffmpeg = findProgram("ffmpeg");
    if (ffmpeg.empty())
        throw InputError(fmt::format("film {}: the program ffmpeg is not in PATH; install it (apt install ffmpeg), or "
                                     "write PNG frames with -o FOLDER",
                                     shownPath(path)));
    FilmFormat format = wanted;
    format.container = containerOf(path);
    if (stream) return std::make_unique<StreamSink>(ffmpeg, path, format);
    return std::make_unique<FilmSink>(ffmpeg, path, format, part);
}

}  // namespace knuckle
