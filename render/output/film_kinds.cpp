#include "render/output/film_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <string_view>

#include "sim/base/files/endings.h"

namespace knuckle {

namespace {

constexpr std::string_view GIF = "gif";
/// A GIF counts hundredths of a second, and browsers slow down one with a frame in each.
constexpr double GIF_MOST_FRAMES = 50.0;

// The bytes of a film depend on an encoder's threads, and must not depend on the machine: their number is fixed.
const std::vector<Encoder>& encoders()
{
    static const std::vector<Encoder> all{
        {"h264",
         "H.264",
         "libx264",
         {"-pix_fmt", "yuv420p", "-crf", "18", "-preset", "veryfast", "-threads", "4"},
         true},
        // Players of Apple know H.265 by this tag alone.
        {"h265",
         "H.265",
         "libx265",
         {"-pix_fmt", "yuv420p", "-crf", "21", "-preset", "fast", "-x265-params", "log-level=error:frame-threads=2",
          "-tag:v", "hvc1"},
         true},
        {"av1", "AV1", "libsvtav1", {"-pix_fmt", "yuv420p", "-crf", "28", "-preset", "8", "-g", "250"}, true},
        {"av1",
         "AV1",
         "libaom-av1",
         {"-pix_fmt", "yuv420p", "-crf", "28", "-b:v", "0", "-cpu-used", "6", "-threads", "4"},
         true},
        {"vp9",
         "VP9",
         "libvpx-vp9",
         {"-pix_fmt", "yuv420p", "-crf", "24", "-b:v", "0", "-deadline", "good", "-cpu-used", "4", "-tile-columns", "2",
          "-threads", "4"},
         true},
        {"gif", "GIF", "gif", {}},
        {"webp",
         "WebP",
         "libwebp_anim",
         {"-pix_fmt", "yuv420p", "-lossless", "0", "-quality", "90", "-compression_level", "4"}},
        {"apng", "APNG", "apng", {"-pix_fmt", "rgb24", "-pred", "mixed"}},
        {"y4m", "YUV4MPEG2", "wrapped_avframe", {"-pix_fmt", "yuv420p"}, true},
    };
    return all;
}

const std::vector<FilmKind>& kinds()
{
    static const std::vector<FilmKind> all{
        {".mp4", "mp4", {"h264", "h265", "av1"}},
        {".mov", "mov", {"h264", "h265"}},
        {".mkv", "matroska", {"h264", "h265", "av1", "vp9"}},
        {".webm", "webm", {"vp9", "av1"}},
        {".gif", "gif", {"gif"}, true},
        {".webp", "webp", {"webp"}, true},
        {".apng", "apng", {"apng"}, true},
        {".y4m", "yuv4mpegpipe", {"y4m"}},
    };
    return all;
}

}  // namespace

std::string choiceOf(std::span<const char* const> words)
{
    std::string text;
    for (size_t k = 0; k < words.size(); ++k)
        text += fmt::format("{}{}", k == 0 ? "" : k + 1 == words.size() ? " or " : ", ", words[k]);
    return text;
}

const FilmKind* filmKindOf(const std::string& path)
{
    const auto found = std::ranges::find(kinds(), endingOf(path), &FilmKind::ending);
    return found == kinds().end() ? nullptr : &*found;
}

bool hasCodecs(const FilmKind& kind)
{
    return kind.codecs.size() > 1;
}

bool isCodec(const std::string& word)
{
    return std::ranges::any_of(kinds(), [&](const FilmKind& kind) {
        return hasCodecs(kind) && std::ranges::count(kind.codecs, std::string_view(word)) > 0;
    });
}

std::vector<const Encoder*> encodersOf(const std::string& codec)
{
    std::vector<const Encoder*> found;
    for (const Encoder& encoder : encoders())
        if (encoder.codec == codec) found.push_back(&encoder);
    return found;
}

const Encoder& losslessEncoder()
{
    static const Encoder ffv1{"ffv1", "FFV1", "ffv1", {"-pix_fmt", "bgr0", "-level", "3", "-g", "1", "-threads", "4"}};
    return ffv1;
}

double frameRateOf(const FilmKind& kind, double wanted)
{
    return kind.container == GIF ? std::min(wanted, GIF_MOST_FRAMES) : wanted;
}

}  // namespace knuckle
