#include "app/golden/golden_images.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>

#include "app/compare/compare_run.h"
#include "app/run/shell_command.h"
#include "sim/base/errors.h"

namespace knuckle {

namespace {

/// What tells a file from one that was written later under its name, a link to it included.
using FileStamp = std::array<uint64_t, 6>;

FileStamp stampOf(const std::string& file)
{
    FileStamp stamp{};
    struct stat info = {};
    const auto note = [&](size_t at) {
        stamp[at] = info.st_ino;
        stamp[at + 1] = static_cast<uint64_t>(info.st_ctim.tv_sec);
        stamp[at + 2] = static_cast<uint64_t>(info.st_ctim.tv_nsec);
    };
    if (lstat(file.c_str(), &info) == 0) note(0);
    if (stat(file.c_str(), &info) == 0) note(3);
    return stamp;
}

}  // namespace

void makeImages(const Golden& golden)
{
    if (golden.command.empty()) return;
    // Commands may use the same files: only one at a time.
    static std::mutex mutex;
    const std::lock_guard lock(mutex);
    std::map<std::string, FileStamp> before;
    for (const std::string& image : golden.images) before[image] = stampOf(golden.imagePath(image));
    const ShellResult result = runShell(golden.command, golden.commandFolder);
    if (!result.failure.empty())
        throw InputError(fmt::format("{}: /command: {} {}{}", golden.path(), golden.command, result.failure,
                                     result.lastLine.empty() ? "" : "; its last line: " + result.lastLine));
    for (const std::string& image : golden.images) {
        const FileStamp now = stampOf(golden.imagePath(image));
        if (now[3] == 0 || now == before[image])
            throw InputError(fmt::format("{}: /command: {} did not write {}", golden.path(), golden.command,
                                         golden.imagePath(image)));
    }
}

void requireOwnReferences(const Golden& golden, const std::string& key)
{
    for (const std::string& image : golden.images) {
        const std::string output = golden.imagePath(image);
        if (std::error_code ignored; std::filesystem::equivalent(golden.imageReference(image, key), output, ignored))
            throw InputError(fmt::format("{}: /images: {} is its own reference; put the golden into another folder",
                                         golden.path(), output));
    }
}

CheckedGolden checkImages(const Golden& golden, const CheckOptions& options)
{
    CheckedGolden checked;
    if (!options.pictures) return checked;
    requireOwnReferences(golden, "");
    makeImages(golden);
    CompareRun run;
    run.settings = golden.settings;
    run.file = golden.pictures;
    run.reports = options.reports;
    for (const std::string& image : golden.images) {
        GoldenItem item{.kind = GoldenItem::Kind::Image, .golden = golden.name, .stem = Golden::imageStem(image)};
        item.entry = compareImageFiles(run, golden.imageReference(image, ""), golden.imagePath(image), item.stem, 1);
        item.entry.name = golden.name + "/" + item.stem;
        noteRemedy(golden, item.entry);
        item.entry.line = fmt::format("{}: {}", kindWord(item.kind), item.entry.line);
        checked.items.push_back(std::move(item));
    }
    return checked;
}

}  // namespace knuckle
