#include <fmt/format.h>

#include <algorithm>

#include "render/output/ffmpeg.h"
#include "render/output/frame_sink.h"
#include "render/output/task_thread.h"
#include "sim/base/errors.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

std::string formatOf(const std::string& path)
{
    const std::string ending = endingOf(path);
    return ending == ".mkv" ? "matroska" : ending == ".mov" ? "mov" : "mp4";
}

/// ffmpeg's output and its format.
std::vector<std::string> outputArguments(const std::string& path, const OutputFile& file)
{
    const std::string format = formatOf(path);
    std::vector<std::string> arguments{"-f", format};
    if (format != "matroska") {
        arguments.emplace_back("-movflags");
        arguments.emplace_back(file.isStream() ? "frag_keyframe+empty_moov+default_base_moof" : "+faststart");
    }
    arguments.push_back(file.isStream() ? "pipe:1" : "file:" + file.temporaryName());
    return arguments;
}

std::vector<std::string> encoderArguments(uint32_t width, uint32_t height, double framesPerSecond)
{
    // Without -xerror ffmpeg reports success for a film that did not fit on the disk.
    std::vector<std::string> arguments = {"-hide_banner", "-loglevel",
                                          "error",        "-xerror",
                                          "-nostdin",     "-y",
                                          "-f",           "rawvideo",
                                          "-pix_fmt",     "rgb24",
                                          "-video_size",  fmt::format("{}x{}", width, height),
                                          "-framerate",   fmt::format("{}", framesPerSecond),
                                          "-i",           "pipe:0",
                                          "-an"};
    const auto add = [&](std::initializer_list<const char*> more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
    };
    // Chroma at half the resolution needs even sizes.
    if (width % 2 != 0 || height % 2 != 0) add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"});
    add({"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-preset", "veryfast"});
    return arguments;
}

std::vector<std::string> joined(std::vector<std::string> list, const std::vector<std::string>& more)
{
    list.insert(list.end(), more.begin(), more.end());
    return list;
}

class FilmSink : public FrameSink {
public:
    FilmSink(const std::string& ffmpeg, const std::string& path, uint32_t width, uint32_t height,
             double framesPerSecond)
        : width_(width), height_(height), file_(path),
          ffmpeg_(ffmpeg, joined(encoderArguments(width, height, framesPerSecond), outputArguments(path, file_)),
                  file_.isStream() ? file_.descriptor() : -1, shownPath(path))
    {
    }

    void write(Image image, uint64_t number) override
    {
        if (image.width != width_ || image.height != height_)
            throw RunError(fmt::format("frame {} is {}x{}, but the film is {}x{}", number, image.width, image.height,
                                       width_, height_));
        writer_.push([this, image = std::move(image)] { ffmpeg_.write(image.rgb.data(), image.rgb.size()); });
    }

    void finish() override
    {
        writer_.drain();
        ffmpeg_.finish();
        file_.commit();
    }

private:
    uint32_t width_, height_;
    // The order matters: first the thread ends, then ffmpeg is stopped, then its output is removed.
    OutputFile file_;
    Ffmpeg ffmpeg_;
    TaskThread writer_{MAX_UNWRITTEN};
};

}  // namespace

std::unique_ptr<FrameSink> filmSink(const std::string& path, uint32_t width, uint32_t height, double framesPerSecond)
{
    if (OutputPlace::of(path).kind != OutputPlace::Kind::Stream && !std::ranges::count(FILM_ENDINGS, endingOf(path)))
        throw InputError(fmt::format("film {}: its kind is not known; name it .mp4, .mov or .mkv", shownPath(path)));
    const std::string ffmpeg = findProgram("ffmpeg");
    if (ffmpeg.empty())
        throw InputError(fmt::format("film {}: the program ffmpeg is not in PATH; install it (apt install ffmpeg), or "
                                     "write PNG frames with -o FOLDER",
                                     shownPath(path)));
    return std::make_unique<FilmSink>(ffmpeg, path, width, height, framesPerSecond);
}

}  // namespace knuckle
