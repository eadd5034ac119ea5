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

/// All segments are of this kind, whatever the film: it has exact times. Those that keep every bit need its elder.
const char* containerOfSegments(const FilmEncoding& encoding)
{
    return encoding.kind->atEnd ? "mov" : "mp4";
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

FilmSegments::FilmSegments(std::string ffmpeg, FilmFormat format, FilmEncoding encoding, std::string purpose,
                           FilmKeep& keep)
    : ffmpeg_(std::move(ffmpeg)), format_(std::move(format)), encoding_(encoding), purpose_(std::move(purpose)),
      keep_(keep)
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
        std::vector<std::string> arguments = encoderArguments(format_, encoding_.segments());
        const std::string file = fmt::format("file:{}/{}", keep_.folder(), encoded_);
        arguments.insert(arguments.end(), {"-fflags", "+bitexact", "-f", containerOfSegments(encoding_), file});
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
    joinSegments(ffmpeg_, encoding_, format_, list, output, purpose_);
}

std::unique_ptr<FilmKeep> temporaryKeep(const std::string& film)
{
    return std::make_unique<TemporaryKeep>(film);
}

}  // namespace knuckle
