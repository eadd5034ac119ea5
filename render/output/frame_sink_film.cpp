#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "render/output/ffmpeg.h"
#include "render/output/film_encoding.h"
#include "render/output/film_kinds.h"
#include "render/output/film_segments.h"
#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

constexpr std::string_view RAW = "raw";

void checkSize(const Image& image, const FilmFormat& format, uint64_t number)
{
    if (image.width != format.width || image.height != format.height)
        throw RunError(fmt::format("frame {} is {}x{}, but the film is {}x{}", number, image.width, image.height,
                                   format.width, format.height));
}

/// Pixels as they are into a stream.
class RawSink : public FrameSink {
public:
    RawSink(const std::string& path, FilmFormat format) : format_(std::move(format)), file_(path) {}
    void write(Image image, uint64_t number) override
    {
        checkSize(image, format_, number);
        writer_.push([this, image = std::move(image)] {
            file_.write({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
        });
    }
    void flush() override { writer_.drain(); }
    void finish() override
    {
        writer_.drain();
        file_.commit();
    }

private:
    FilmFormat format_;
    OutputFile file_;  // closed after the thread has ended
    TaskThread writer_{MAX_UNWRITTEN};
};

/// Into a stream, in one piece.
class StreamSink : public FrameSink {
public:
    StreamSink(const std::string& ffmpeg, const std::string& path, FilmFormat format, const FilmEncoding& encoding)
        : format_(std::move(format)), file_(path),
          ffmpeg_(ffmpeg, arguments(format_, encoding), file_.descriptor(), shownPath(path))
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
    static std::vector<std::string> arguments(const FilmFormat& format, const FilmEncoding& encoding)
    {
        std::vector<std::string> list = encoderArguments(format, *encoding.encoder);
        const std::string container = encoding.kind->container;
        list.insert(list.end(), {"-f", container});
        // A stream has no way back.
        if (container == "mp4" || container == "mov")
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
    FilmSink(const std::string& ffmpeg, const std::string& path, const FilmFormat& format, const FilmEncoding& encoding,
             const FilmPart& part)
        : format_(format), first_(part.first), last_(part.last), stride_(part.stride), file_(path),
          own_(part.keep != nullptr ? nullptr : temporaryKeep(path)),
          segments_(ffmpeg, format, encoding, shownPath(path), part.keep != nullptr ? *part.keep : *own_)
    {
    }

    bool wants(uint64_t number) override { return own_ != nullptr || segments_.wants(indexOf(number)); }
    void write(Image image, uint64_t number) override
    {
        checkSize(image, format_, number);
        if (first_ == 0) first_ = number;
        last_ = std::max(last_, number);
        writer_.push([this, index = indexOf(number), image = std::move(image)] { segments_.write(index, image.rgb); });
    }
    void flush() override { writer_.drain(); }
    void finish() override
    {
        writer_.drain();
        segments_.finish(indexOf(last_) + 1, file_.temporaryName());
        file_.commit();
        own_.reset();
    }

private:
    uint64_t indexOf(uint64_t number) const { return (number - first_) / stride_; }

    FilmFormat format_;
    uint64_t first_, last_, stride_;
    // The order matters: first the thread ends, then ffmpeg is stopped, then its outputs are removed.
    OutputFile file_;
    std::unique_ptr<FilmKeep> own_;
    FilmSegments segments_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

namespace {

/// @throws InputError for a name that ends in no film's ending, and for a stream of what is no stream.
const FilmKind& kindOf(const std::string& path, const FilmFormat& format, bool stream)
{
    const FilmKind* kind = filmKindOf(stream && !format.pipe.empty() ? "pipe." + format.pipe : path);
    if (stream && kind == nullptr) kind = filmKindOf("pipe.mp4");
    if (stream && kind->atEnd)
        throw InputError(fmt::format("film {}: a {} is made when all frames are known, and cannot go into a stream; "
                                     "give it a file, or --pipe {}",
                                     shownPath(path), kind->ending, choiceOf(PIPE_WORDS)));
    if (!stream && !std::ranges::count(FILM_ENDINGS, endingOf(path)))
        throw InputError(
            fmt::format("film {}: its kind is not known; name it {}", shownPath(path), choiceOf(FILM_ENDINGS)));
    return *kind;
}

}  // namespace

std::unique_ptr<FrameSink> filmSink(const std::string& path, const FilmFormat& format, const FilmPart& part)
{
    const bool stream = OutputPlace::of(path).kind == OutputPlace::Kind::Stream;
    if (stream && format.pipe == RAW) return std::make_unique<RawSink>(path, format);
    const FilmKind& kind = kindOf(path, format, stream);
    const std::string ffmpeg = findProgram("ffmpeg");
    if (ffmpeg.empty())
        throw InputError(fmt::format("film {}: the program ffmpeg is not in PATH; install it (apt install ffmpeg), or "
                                     "write PNG frames with -o FOLDER",
                                     shownPath(path)));
    const FilmEncoding encoding = chooseEncoding(ffmpeg, kind, format, shownPath(path));
    if (stream) return std::make_unique<StreamSink>(ffmpeg, path, format, encoding);
    return std::make_unique<FilmSink>(ffmpeg, path, format, encoding, part);
}

}  // namespace knuckle
