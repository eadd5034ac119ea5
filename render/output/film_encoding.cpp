#include "render/output/film_encoding.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>

#include "render/output/ffmpeg.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

using Arguments = std::vector<std::string>;

void add(Arguments& arguments, const std::vector<const char*>& more)
{
    arguments.insert(arguments.end(), more.begin(), more.end());
}

/// Chroma at half the resolution needs even sizes.
void addEncoder(Arguments& arguments, const FilmFormat& format, const Encoder& encoder)
{
    if (encoder.even && (format.width % 2 != 0 || format.height % 2 != 0))
        add(arguments, {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2"});
    add(arguments, {"-c:v", encoder.name});
    add(arguments, encoder.arguments);
}

/// Runs ffmpeg on a list of segments.
void runOnList(const std::string& ffmpeg, Arguments arguments, const std::string& list, const std::string& purpose)
{
    Ffmpeg run(ffmpeg, std::move(arguments), -1, purpose);
    run.write(list.data(), list.size());
    run.finish();
}

Arguments readingList()
{
    return quietly({"-protocol_whitelist", "file,pipe", "-f", "concat", "-safe", "0", "-i", "pipe:0"});
}

/// The film without its palette would have 216 colours, the same for every film.
void joinGif(const std::string& ffmpeg, const std::string& list, const std::string& rate, const std::string& output,
             const std::string& purpose)
{
    // Never completed, so that it is removed. In two passes: in one, all frames would wait in memory for the palette.
    const OutputFile palette(output);
    Arguments first = readingList(), second = readingList();
    first.insert(first.end(),
                 {"-vf", "palettegen", "-c:v", "png", "-f", "image2pipe", "file:" + palette.temporaryName()});
    second.insert(second.end(), {"-f", "png_pipe", "-i", "file:" + palette.temporaryName(), "-lavfi",
                                 fmt::format("[0:v]fps={}[x];[x][1:v]paletteuse=dither=bayer:bayer_scale=4:"
                                             "diff_mode=rectangle",
                                             rate),
                                 "-c:v", "gif", "-fflags", "+bitexact", "-loop", "0", "-f", "gif", "file:" + output});
    runOnList(ffmpeg, first, list, purpose);
    runOnList(ffmpeg, second, list, purpose);
}

}  // namespace

Arguments quietly(std::initializer_list<std::string> more)
{
    // Without -xerror ffmpeg reports success for a film that did not fit on the disk.
    Arguments arguments{"-hide_banner", "-loglevel", "error", "-xerror", "-nostdin", "-y"};
    arguments.insert(arguments.end(), more);
    return arguments;
}

Arguments encoderArguments(const FilmFormat& format, const Encoder& encoder)
{
    Arguments arguments = quietly({"-f", "rawvideo", "-pix_fmt", "rgb24", "-video_size",
                                   fmt::format("{}x{}", format.width, format.height), "-framerate",
                                   fmt::format("{}", format.framesPerSecond), "-i", "pipe:0", "-an"});
    addEncoder(arguments, format, encoder);
    return arguments;
}

void joinSegments(const std::string& ffmpeg, const FilmEncoding& encoding, const FilmFormat& format,
                  const std::string& list, const std::string& output, const std::string& purpose)
{
    const std::string_view container = encoding.kind->container;
    const std::string rate = fmt::format("{}", frameRateOf(*encoding.kind, format.framesPerSecond));
    if (container == "gif") return joinGif(ffmpeg, list, rate, output, purpose);
    Arguments arguments = readingList();
    if (encoding.kind->atEnd) {
        add(arguments, {"-vf", ("fps=" + rate).c_str()});
        addEncoder(arguments, format, *encoding.encoder);
        // Again and again, as a GIF.
        add(arguments, {container == "apng" ? "-plays" : "-loop", "0"});
    } else {
        add(arguments, {"-c", "copy"});
        if (std::ranges::count(encoding.encoder->arguments, std::string_view("hvc1")) > 0 && container != "matroska")
            add(arguments, {"-tag:v", "hvc1"});
    }
    add(arguments, {"-fflags", "+bitexact", "-f", encoding.kind->container});
    if (container == "mp4" || container == "mov") add(arguments, {"-movflags", "+faststart"});
    arguments.push_back("file:" + output);
    runOnList(ffmpeg, arguments, list, purpose);
}

FilmEncoding chooseEncoding(const std::string& ffmpeg, const FilmKind& kind, const FilmFormat& format,
                            const std::string& shown)
{
    std::string codec = kind.codecs[0];
    if (!format.codec.empty() && hasCodecs(kind)) codec = format.codec;
    if (!std::ranges::count(kind.codecs, std::string_view(codec)))
        throw InputError(fmt::format("film {}: a {} has no {}; choose --codec {}, or another ending", shown,
                                     kind.ending, codec, choiceOf(kind.codecs)));
    std::string why;
    std::vector<const char*> names;
    const std::vector<const Encoder*> encoders = encodersOf(codec);
    for (const Encoder* encoder : encoders) {
        Arguments arguments = quietly(
            {"-f", "lavfi", "-i",
             fmt::format("color=black:size={}x{}:rate={}", format.width, format.height, format.framesPerSecond),
             "-frames:v", "1", "-an"});
        addEncoder(arguments, format, *encoder);
        add(arguments, {"-f", "null", "-"});
        names.push_back(encoder->name);
        try {
            Ffmpeg(ffmpeg, std::move(arguments), -1, encoder->name).finish();
            return {&kind, encoder};
        } catch (const RunError& error) {
            why += fmt::format("{}{}", why.empty() ? "" : "; ", error.what());
        }
    }
    throw InputError(fmt::format("film {}: {} cannot encode {} with {} ({}); install an ffmpeg that has it, or choose "
                                 "another ending{}",
                                 shown, ffmpeg, encoders[0]->title, fmt::join(names, " or "), why,
                                 hasCodecs(kind) ? " or --codec" : ""));
}

}  // namespace knuckle
