#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

namespace knuckle {

/// An encoder of ffmpeg, and what it is told.
struct Encoder {
    const char* codec;  ///< As `--codec` names it, or a kind's own.
    const char* title;  ///< For people.
    const char* name;   ///< ffmpeg's name of it.
    std::vector<const char*> arguments;
    bool even = false;  ///< Wants even sizes, having chroma at half the resolution.
};

/// A kind of film, by its name's ending.
struct FilmKind {
    const char* ending;
    const char* container;            ///< ffmpeg's name of it.
    std::vector<const char*> codecs;  ///< Which it may have; the first unless another is wanted.
    /// Frames depend on others all over the film, or do not follow each other in packets: its segments cannot be
    /// joined. They are kept without loss, and the film is encoded of them at the end.
    bool atEnd = false;
};

/// Endings of films that can be written.
inline constexpr std::array FILM_ENDINGS{".mp4", ".mov", ".mkv", ".webm", ".gif", ".webp", ".apng"};
/// Words to choose from, for people: "a, b or c".
std::string choiceOf(std::span<const char* const> words);

/// Null for another ending.
const FilmKind* filmKindOf(const std::string& path);
/// Whether films of that name have a codec to choose.
bool hasCodecs(const FilmKind& kind);
/// Whether it is a word of `--codec`.
bool isCodec(const std::string& word);
/// The encoders of a codec, best first.
std::vector<const Encoder*> encodersOf(const std::string& codec);
/// Keeps every bit; of segments from which a film is encoded at the end.
const Encoder& losslessEncoder();
/// Frames a second that the kind can have; others are left out. @param wanted [1/s].
double frameRateOf(const FilmKind& kind, double wanted);

}  // namespace knuckle
