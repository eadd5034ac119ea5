#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <optional>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/files/run_paths.h"
#include "render/picture/image.h"
#include "sim/base/files/endings.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace {

struct CompareOptions {
    std::string first, second, difference;
    uint32_t threshold = 8;
    double maxChanged = 0.001;
};

int compare(const CompareOptions& options, bool quiet)
{
    std::optional<OutputFile> difference;
    if (!options.difference.empty()) {
        requireEnding("--difference ", options.difference, "a picture", {".png"});
        RunPaths paths;
        paths.reads(options.first);
        paths.reads(options.second);
        paths.writes(options.difference);
        paths.check();
        difference.emplace(options.difference);
    }
    const Image first = readImage(options.first), second = readImage(options.second);
    const ImageDifference result = compareImages(first, second, options.threshold);
    const bool different = result.changedFraction > options.maxChanged;
    if (difference) {
        difference->write(pngOf(result.picture));
        difference->commit();
    }
    if (!quiet) {
        fmt::print("{}: {:.4f} % of the pixels differ by more than {} of 255 (allowed {:.4f} %), mean {:.4f}, "
                   "worst {}\n",
                   different ? "different" : "equal", 100.0 * result.changedFraction, options.threshold,
                   100.0 * options.maxChanged, result.meanAbsolute, result.worst);
    }
    return different ? EXIT_DIFFERENT : EXIT_FINE;
}

}  // namespace

void addCompareCommand(CommandLine line)
{
    auto* command = line.program.add_subcommand("compare", "Compare two images; exit code 4 when they differ");
    command->fallthrough();
    command->footer("Two drivers round differently at edges, so a few pixels may differ by more than the threshold.\n\n"
                    "Example:\n  knuckle compare golden.png out/hello/frame_0060.png --difference difference.png");
    auto options = std::make_shared<CompareOptions>();
    command->add_option("A", options->first, "An image")->required();
    command->add_option("B", options->second, "An image of the same size")->required();
    command->add_option("--threshold", options->threshold, "A pixel has changed when a channel differs by more, 0-255")
        ->check(CLI::Range(0, 255))
        ->capture_default_str();
    command->add_option("--max-changed", options->maxChanged, "Share of changed pixels that still counts as equal, 0-1")
        ->check(numberBetween(0.0, 1.0))
        ->capture_default_str();
    command->add_option("--difference", options->difference, "Write a picture of the difference")->type_name("OUT.png");
    command->callback([=] { line.chosen = [=] { return compare(*options, line.common.quiet); }; });
}

}  // namespace knuckle
