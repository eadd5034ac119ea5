#pragma once

#include <string>
#include <vector>

#include "render/output/film_kinds.h"
#include "render/output/frame_sink.h"

namespace knuckle {

/// How ffmpeg makes one film.
struct FilmEncoding {
    const FilmKind* kind = nullptr;
    const Encoder* encoder = nullptr;

    /// What segments are encoded with.
    const Encoder& segments() const { return kind->atEnd ? losslessEncoder() : *encoder; }
};

/// Arguments of every call of ffmpeg, then some more.
std::vector<std::string> quietly(std::initializer_list<std::string> more);
/// Arguments that make ffmpeg read raw frames on its standard input and encode them, without the output.
std::vector<std::string> encoderArguments(const FilmFormat& format, const Encoder& encoder);

/// Makes a film of its segments.
/// @param list of segments, as ffmpeg's concat reads it. @param output file that gets the film. @param purpose names it
/// in messages. @throws RunError.
void joinSegments(const std::string& ffmpeg, const FilmEncoding& encoding, const FilmFormat& format,
                  const std::string& list, const std::string& output, const std::string& purpose);

/// The encoder for a film, tried on a black frame, so that nothing is simulated in vain.
/// @param ffmpeg path of the program. @param shown name of the film in messages.
/// @throws InputError for a codec that the kind cannot have, and where the installed ffmpeg has no encoder for it.
FilmEncoding chooseEncoding(const std::string& ffmpeg, const FilmKind& kind, const FilmFormat& format,
                            const std::string& shown);

}  // namespace knuckle
