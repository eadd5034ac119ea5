#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/compare/compare_run.h"
#include "app/compare/ignored_words.h"
#include "render/reader/picture_file.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// Words of options, before they are understood.
struct CompareWords {
    CompareRun run;
    std::string limits, mask, background = "000000";
    std::vector<std::string> ignored, ignoredColors;
};

int compare(const CompareWords& words, bool quiet)
{
    CompareRun run = words.run;
    run.quiet = quiet;
    for (const std::string& word : words.ignored) run.settings.ignored.boxes.push_back(parseBox("--ignore", word));
    for (const std::string& word : words.ignoredColors)
        run.settings.ignored.colors.push_back(parseColor("--ignore-color", word));
    const std::array<uint8_t, 3> background = parseColor("--background", words.background);
    for (size_t c = 0; c < 3; ++c) run.settings.flip.background[c] = static_cast<float>(background[c]) / STEPS;
    for (const std::string& input : {words.limits, words.mask})
        if (!input.empty()) run.otherInputs.push_back(input);
    if (!words.limits.empty()) run.file = readLimits(words.limits);
    if (!words.mask.empty()) run.settings.ignored.mask = std::make_shared<const Picture>(readPicture(words.mask));
    checkReportOptions(run.reports, run.json);
    std::error_code ignored;
    const bool folders = std::filesystem::is_directory(run.first, ignored) &&
                         std::filesystem::is_directory(run.second, ignored);
    if (folders) return compareFolders(run);
    if (!run.patterns.empty() || run.allowNew)
        throw InputError("--pattern and --allow-new are for two folders; name two, or leave them out");
    return compareTwoImages(run);
}

constexpr const char* FOOTER =
    "A and B are PNG, JPEG or OpenEXR files, told apart by content, or two folders whose images are compared by name, "
    "folders in them too. A is the reference.\n\n"
    "Without options images pass that two drivers make of one scene: roundings, single pixels of edges. A few pixels "
    "that stand alone, a thing that is gone, a change of brightness do not. All differences are in steps of 8-bit "
    "channels, 0 to 255; colours count as much as alpha shows of them.\n\n"
    "Exit codes: 0 equal, 4 different (in size as well, or an image is missing or new), 2 what cannot be read.\n\n"
    "Examples:\n"
    "  knuckle compare golden.png out/hello/frame_0060.png --difference difference.png\n"
    "  knuckle compare a.png b.png --threshold 0 --max-pixels 0     any difference counts\n"
    "  knuckle compare a.png b.png --ignore 0,0,200x40 --ignore-antialiasing\n"
    "  knuckle compare a.exr b.exr --max-flip 0.02 --heatmap flip.png\n"
    "  knuckle compare golden out --limits limits.json --difference failures --json > report.json\n"
    "  knuckle compare golden out --report report.html --junit report.xml --annotations github\n\n"
    "docs/compare.md says what each figure is, and `knuckle schema limits` what a file of limits holds.";

void addLimits(CLI::App& command, CompareWords& words)
{
    GivenLimits& given = words.run.given;
    const auto limit = [&command](const char* name, auto& value, double lowest, double highest, const char* text) {
        command.add_option(name, value, text)
            ->check(numberBetween(lowest, highest).description(""))
            ->type_name("N")
            ->group("What counts as equal");
    };
    limit("--threshold", given.threshold, 0, 255, "A pixel has changed where a channel differs by more, 0-255 [8]");
    limit("--max-changed", given.share, 0, 1, "Share of the pixels that may have changed, 0-1 [0.005]");
    limit("--max-pixels", given.pixels, 0, static_cast<double>(MAX_PICTURE_PIXELS),
          "How many pixels may have changed; replaces --max-changed, unless that is given, too");
    limit("--max-mean", given.mean, 0, 255, "Mean difference over all pixels and channels, 0-255 [1]");
    limit("--max-difference", given.largest, 0, 255, "Largest difference of a channel, 0-255 [any]");
    limit("--max-tile", given.tile, 0, 1000, "Score of the worst tile: finds what is small and plain to see [1]");
    limit("--max-flip", given.flip, 0, 1, "Mean of FLIP, how much a person sees them differ, 0-1 [0.05]");
    limit("--min-ssim", given.ssim, -1, 1, "Least mean of SSIM, structural similarity, -1 to 1 [any]");
    command.add_option("--limits", words.limits, "Limits by name from a JSON file; options above come before it")
        ->type_name("FILE")
        ->group("What counts as equal");
}

void addIgnored(CLI::App& command, CompareWords& words)
{
    const auto list = [&command](const char* name, std::vector<std::string>& values, const char* text,
                                 const char* type) {
        command.add_option(name, values, text)
            ->type_name(type)
            ->take_all()
            ->allow_extra_args(false)
            ->group("What is compared");
    };
    list("--ignore", words.ignored, "Leave out a rectangle; may be repeated", "X,Y,WxH");
    list("--ignore-color", words.ignoredColors, "Leave out pixels of a colour in either image; may be repeated",
         "RRGGBB");
    command.add_option("--mask", words.mask, "Leave out what is black or transparent in an image of the same size")
        ->type_name("FILE")
        ->group("What is compared");
    command
        .add_flag("--ignore-antialiasing", words.run.settings.ignoreAntialiasing,
                  "Leave out pixels of smooth edges that have moved by less than a pixel")
        ->group("What is compared");
    list("--pattern", words.run.patterns, "Of folders: only images whose name matches; may be repeated", "GLOB");
    command.add_flag("--allow-new", words.run.allowNew, "Of folders: images that are only in B are no difference")
        ->group("What is compared");
    command
        .add_option("--pixels-per-degree", words.run.settings.flip.pixelsPerDegree,
                    "How many pixels a degree of sight holds, for FLIP [67.02]")
        ->check(numberBetween(1, 1000).description(""))
        ->type_name("N")
        ->group("What is compared");
    command
        .add_option("--background", words.background,
                    "On which FLIP and SSIM see images with transparent parts [000000]")
        ->type_name("RRGGBB")
        ->group("What is compared");
}

}  // namespace

void addCompareCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand(
        "compare", "Compare two images, or all images of two folders; exit code 4 when they differ");
    command->fallthrough();
    command->footer(FOOTER);
    auto words = std::make_shared<CompareWords>();
    command->add_option("A", words->run.first, "An image, or a folder of images")->required();
    command->add_option("B", words->run.second, "What to compare with it")->required();
    addLimits(*command, *words);
    addIgnored(*command, *words);
    command->add_option("--difference", words->run.difference, "Write a picture of the difference; of folders a folder")
        ->type_name("OUT.png");
    command->add_option("--heatmap", words->run.heatmap, "Write a picture of FLIP's errors; of folders a folder")
        ->type_name("OUT.png");
    addReportOptions(*command, words->run.reports);
    command->add_flag("--json", words->run.json, "Print all figures as JSON, also with --quiet");
    command->callback([=] { line.chosen = [=] { return compare(*words, line.common.quiet); }; });
}

}  // namespace knuckle
