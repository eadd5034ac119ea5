#include "app/golden/golden_images.h"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <optional>

#include "app/compare/compare_run.h"
#include "app/run/shell_command.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

std::optional<fs::file_time_type> timeOf(const fs::path& file)
{
    std::error_code error;
    const fs::file_time_type time = fs::last_write_time(file, error);
    return error ? std::nullopt : std::optional(time);
}

}  // namespace

void makeImages(const Golden& golden)
{
    if (golden.command.empty()) return;
    std::map<std::string, std::optional<fs::file_time_type>> before;
    for (const std::string& image : golden.images) before[image] = timeOf(fs::path(golden.commandFolder) / image);
    const ShellResult result = runShell(golden.command, golden.commandFolder);
    if (!result.failure.empty())
        throw InputError(fmt::format("{}: /command: {} {}{}", golden.path(), golden.command, result.failure,
                                     result.lastLine.empty() ? "" : "; its last line: " + result.lastLine));
    for (const std::string& image : golden.images) {
        const auto now = timeOf(fs::path(golden.commandFolder) / image);
        if (!now || now == before[image])
            throw InputError(fmt::format("{}: /command: {} did not write {}", golden.path(), golden.command,
                                         (fs::path(golden.commandFolder) / image).lexically_normal().string()));
    }
}

CheckedGolden checkImages(const Golden& golden, const CheckOptions& options)
{
    CheckedGolden checked;
    if (!options.pictures) return checked;
    makeImages(golden);
    CompareRun run;
    run.settings = golden.settings;
    run.file = golden.pictures;
    run.reports = options.reports;
    for (const std::string& image : golden.images) {
        const fs::path output = fs::path(golden.commandFolder) / image;
        GoldenItem item{.kind = GoldenItem::Kind::Image, .golden = golden.name, .stem = output.stem().string()};
        item.entry = compareImageFiles(run, golden.reference(item.stem, "", output.extension().string()),
                                       output.string(), item.stem, 1);
        item.entry.name = golden.name + "/" + item.stem;
        if (item.entry.status != ReportEntry::Status::Equal)
            item.entry.notes.emplace_back("accept by", fmt::format("knuckle golden update {}", golden.folder));
        item.entry.line = fmt::format("{}: {}", kindWord(item.kind), item.entry.line);
        checked.items.push_back(std::move(item));
    }
    return checked;
}

}  // namespace knuckle
