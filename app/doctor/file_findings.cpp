#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <sstream>
#include <system_error>

#include "app/doctor/bounded.h"
#include "app/doctor/machine_findings.h"
#include "app/files/assets.h"
#include "render/output/ffmpeg.h"
#include "render/output/film_encoding.h"
#include "render/settings.h"

namespace knuckle {

namespace {

constexpr int ENCODER_SECONDS = 20;
constexpr const char* SCENE = "assets/scenes/hello.json";
const FilmFormat TRIAL{.width = 64, .height = 64, .framesPerSecond = 25.0};

/// A codec, with the endings of films that have it unless another is chosen, and those that may have it.
struct Codec {
    std::string word = {};
    const FilmKind* kind = nullptr;
    std::vector<std::string> first = {}, others = {};
};

std::vector<Codec> codecs()
{
    std::vector<Codec> all;
    for (const char* ending : FILM_ENDINGS) {
        const FilmKind* kind = filmKindOf(std::string("film") + ending);
        if (kind == nullptr) continue;
        for (const char* word : kind->codecs) {
            auto found = std::ranges::find(all, word, &Codec::word);
            if (found == all.end()) found = all.insert(all.end(), Codec{word, kind});
            (word == kind->codecs[0] ? found->first : found->others).push_back(ending);
        }
    }
    return all;
}

/// Whether ffmpeg encodes it.
bool isEncoded(const std::string& ffmpeg, const Codec& codec)
{
    const auto trial = [&] {
        FilmFormat format = TRIAL;
        format.codec = codec.word;
        return std::string(chooseEncoding(ffmpeg, *codec.kind, format, "").encoder->name);
    };
    return runBounded(trial, ENCODER_SECONDS).failure.empty();
}

void findFfmpeg(Findings& findings)
{
    const std::string ffmpeg = findProgram("ffmpeg");
    if (ffmpeg.empty()) {
        findings.push_back({Health::Wrong, "ffmpeg is not in PATH: frames can be made, films cannot",
                            "install it (apt install ffmpeg)"});
        return;
    }
    const auto start = [&] {
        Ffmpeg(ffmpeg, {"-version"}, -1, ffmpeg).finish();
        return std::string();
    };
    if (const std::string failure = runBounded(start, ENCODER_SECONDS).failure; !failure.empty()) {
        findings.push_back({Health::Wrong, fmt::format("ffmpeg does not start, so no films: {}", failure),
                            "install it anew (apt install --reinstall ffmpeg), or put another one into PATH"});
        return;
    }
    std::vector<std::string> fine;
    Findings lacking;
    for (const Codec& codec : codecs()) {
        const std::string title = encodersOf(codec.word)[0]->title;
        if (isEncoded(ffmpeg, codec)) fine.push_back(title);
        else if (!codec.first.empty())
            lacking.push_back({Health::Wrong,
                               fmt::format("ffmpeg cannot encode {}: no {}", title, fmt::join(codec.first, ", ")),
                               "install an ffmpeg that has it, or end films in something else"});
        else
            lacking.push_back(
                {Health::Note, fmt::format("ffmpeg cannot encode {}: --codec {} is not to be had", title, codec.word)});
    }
    if (!fine.empty()) findings.push_back({Health::Ok, fmt::format("{} encodes {}", ffmpeg, fmt::join(fine, ", "))});
    findings.insert(findings.end(), lacking.begin(), lacking.end());
}

}  // namespace

Findings findFiles()
{
    Findings findings;
    findFfmpeg(findings);
    const std::string font = OverlaySettings{}.font;
    if (access(font.c_str(), R_OK) == 0) findings.push_back({Health::Ok, "font " + font});
    else
        findings.push_back({Health::Wrong, fmt::format("font {} cannot be read: no captions and labels", font),
                            "install it (apt install fonts-dejavu-core)"});
    const std::string scene = findAsset(SCENE);
    if (access(scene.c_str(), R_OK) == 0) findings.push_back({Health::Ok, "assets: " + scene});
    else
        findings.push_back({Health::Note, fmt::format("assets: there is no {} here, and none is installed", SCENE),
                            "give paths of scenes, or install (cmake --install)"});
    return findings;
}

}  // namespace knuckle
