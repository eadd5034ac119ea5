#include "render/output/film_segments.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <utility>

#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

/// Of x264: its bytes depend on it, and must not depend on the machine.
constexpr const char* ENCODER_THREADS = "4";
/// All segments are of this kind, whatever the film: it has exact times.
constexpr const char* SEGMENT_CONTAINER = "mp4";

using Arguments = std::vector<std::string>;

Arguments quietly(std::initializer_list<std::string> more)
{
    // Without -xerror ffmpeg reports success for a film that did not fit on the disk.
    Arguments arguments{"-hide_banner", "-loglevel", "error", "-xerror", "-nostdin", "-y"};
    arguments.insert(arguments.end(), more);
    return arguments;
}

/// A folder under a name without characters that mean something in ffmpeg's lists.
class PlainFolder {
public:
    explicit PlainFolder(const std::string& folder)
        : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
    {
    }
    std::string name() const { return fmt::format("/proc/{}/fd/{}", getpid(), descriptor_.get()); }

private:
    FileDescriptor descriptor_;
};

class TemporaryKeep : public FilmKeep {
public:
    explicit TemporaryKeep(std::string film) : film_(std::move(film)), folder_(folderOf(OutputPlace::of(film_).path)) {}
    std::string folder() const override { return folder_; }
    std::string segment(uint64_t segment) override
    {
        return segment < complete_.size() ? nameOf(*complete_[segment]) : "";
    }
    bool hasFrame(uint64_t /*index*/) override { return false; }
    std::vector<uint8_t> readFrame(uint64_t /*index*/) override { return {}; }
    void keepFrame(uint64_t /*index*/, const std::vector<uint8_t>& /*rgb*/) override {}
    std::string beginSegment() override
    {
        begun_ = std::make_unique<OutputFile>(film_);
        return nameOf(*begun_);
    }
    void endSegment(uint64_t /*segment*/, const std::string& /*name*/) override
    {
        complete_.push_back(std::move(begun_));
    }

private:
    /// An output that is never completed is removed.
    using Temporary = std::unique_ptr<OutputFile>;
    static std::string nameOf(const OutputFile& file) { return std::filesystem::path(file.temporaryName()).filename(); }

    std::string film_, folder_;
    Temporary begun_;
    std::vector<Temporary> complete_;
};

}  // namespace

Arguments encoderArguments(const FilmFormat& format)
{
    Arguments arguments = quietly({"-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
                                   fmt::format("{}x{}", format.width, format.height), "-framerate",
                                   fmt::format("{}", format.framesPerSecond), "-i", "pipe:0", "-an"});
    const auto add = [&](std::initializer_list<const char*> more) {
        arguments.insert(arguments.end(), more.begin(), more.end());
    };
    // Chroma at half the resolution needs even sizes.
    if (format.width % 2 != 0 || format.height % 2 != 0) add({"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"});
    add({"-c:v", "libx264", "-pix_fmt", "yuv420p", "-crf", "18", "-preset", "veryfast", "-threads", ENCODER_THREADS});
    return arguments;
}

FilmSegments::FilmSegments(std::string ffmpeg, FilmFormat format, std::string purpose, FilmKeep& keep)
    : ffmpeg_(std::move(ffmpeg)), format_(std::move(format)), purpose_(std::move(purpose)), keep_(keep)
{
}

bool FilmSegments::wants(uint64_t index)
{
    return keep_.segment(index / SEGMENT_FRAMES).empty() && !keep_.hasFrame(index);
}

void FilmSegments::write(uint64_t index, const std::vector<uint8_t>& rgb)
{
    if (!wants(index)) return;
    keep_.keepFrame(index, rgb);
    feedKept(index);
    feed(rgb);
}

void FilmSegments::skipComplete()
{
    while (next_ % SEGMENT_FRAMES == 0 && !keep_.segment(next_ / SEGMENT_FRAMES).empty()) next_ += SEGMENT_FRAMES;
}

void FilmSegments::feedKept(uint64_t end)
{
    for (skipComplete(); next_ < end; skipComplete()) feed(keep_.readFrame(next_));
}

void FilmSegments::feed(const std::vector<uint8_t>& rgb)
{
    if (!encoder_) {
        encoded_ = keep_.beginSegment();
        Arguments arguments = encoderArguments(format_);
        const std::string file = fmt::format("file:{}/{}", keep_.folder(), encoded_);
        arguments.insert(arguments.end(), {"-fflags", "+bitexact", "-f", SEGMENT_CONTAINER, file});
        encoder_.emplace(ffmpeg_, std::move(arguments), -1, purpose_);
    }
    encoder_->write(rgb.data(), rgb.size());
    if (++next_ % SEGMENT_FRAMES != 0) return;
    encoder_->finish();
    encoder_.reset();
    keep_.endSegment(next_ / SEGMENT_FRAMES - 1, encoded_);
}

void FilmSegments::finish(uint64_t frames, const std::string& output)
{
    feedKept(frames);
    if (encoder_) encoder_->finish();
    std::vector<std::string> names;
    for (uint64_t segment = 0; segment < frames / SEGMENT_FRAMES; ++segment) names.push_back(keep_.segment(segment));
    if (frames % SEGMENT_FRAMES != 0) names.push_back(encoded_);
    join(frames, names, output);
}

void FilmSegments::join(uint64_t frames, const std::vector<std::string>& names, const std::string& output) const
{
    const PlainFolder folder(keep_.folder());
    // Times are whole microseconds in such a list: each is rounded by itself, so that they do not drift.
    const auto microseconds = [&](uint64_t frame) {
        return std::llround(1e6 * static_cast<double>(frame) / format_.framesPerSecond);
    };
    std::string list = "ffconcat version 1.0\n";
    for (uint64_t k = 0; k < names.size(); ++k) {
        const uint64_t begin = k * SEGMENT_FRAMES, end = std::min(frames, begin + SEGMENT_FRAMES);
        list += fmt::format("file 'file:{}/{}'\nduration {}us\n", folder.name(), names[k],
                            microseconds(end) - microseconds(begin));
    }
    Arguments arguments = quietly({"-protocol_whitelist", "file,pipe", "-f", "concat", "-safe", "0", "-i", "pipe:0",
                                   "-c", "copy", "-fflags", "+bitexact", "-f", format_.container});
    if (format_.container != "matroska") arguments.insert(arguments.end(), {"-movflags", "+faststart"});
    arguments.push_back("file:" + output);
    Ffmpeg ffmpeg(ffmpeg_, std::move(arguments), -1, purpose_);
    ffmpeg.write(list.data(), list.size());
    ffmpeg.finish();
}

std::unique_ptr<FilmKeep> temporaryKeep(const std::string& film)
{
    return std::make_unique<TemporaryKeep>(film);
}

}  // namespace knuckle
