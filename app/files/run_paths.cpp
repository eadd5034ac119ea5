#include "app/files/run_paths.h"

#include <fmt/format.h>
#include <sys/stat.h>

#include <filesystem>
#include <system_error>
#include <utility>

#include "app/files/model_files.h"
#include "sim/base/errors.h"
#include "sim/base/files/output_place.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

std::string canonical(const std::string& path)
{
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    return error ? path : fs::weakly_canonical(absolute, error).string();
}

}  // namespace

RunPaths::Place RunPaths::outputAt(const std::string& path)
{
    const OutputPlace place = OutputPlace::of(path);
    Place result{place.given, place.path};
    struct stat facts = {};
    const int failed = place.path.empty() ? fstat(place.descriptor, &facts) : stat(place.path.c_str(), &facts);
    result.isStream = place.kind == OutputPlace::Kind::Stream;
    result.exists = failed == 0 && (S_ISREG(facts.st_mode) || S_ISDIR(facts.st_mode));
    result.keeps = failed == 0 && result.isStream && !S_ISCHR(facts.st_mode);
    result.device = facts.st_dev;
    result.inode = facts.st_ino;
    return result;
}

RunPaths::Place RunPaths::inputAt(const std::string& path)
{
    Place result{shownPath(path), canonical(path)};
    struct stat facts = {};
    result.exists = stat(path.c_str(), &facts) == 0 && (S_ISREG(facts.st_mode) || S_ISDIR(facts.st_mode));
    result.device = facts.st_dev;
    result.inode = facts.st_ino;
    return result;
}

bool RunPaths::isSame(const Place& a, const Place& b)
{
    if (a.exists && b.exists) return a.device == b.device && a.inode == b.inode;
    return !a.path.empty() && a.path == b.path && !a.isStream && !b.isStream;
}

/// Whether a folder's frames would overwrite a file.
bool RunPaths::isFrameOf(const Place& folder, const Place& file)
{
    const fs::path path = file.path;
    return folder.frames && folder.frames->has(path.filename().string()) &&
           isSame(folder, inputAt(path.parent_path().string()));
}

void RunPaths::reads(const std::string& file)
{
    inputs_.push_back(inputAt(file));
}

void RunPaths::readsModel(const std::string& file)
{
    reads(file);
    for (const std::string& named : filesOfModel(file)) reads(named);
}

void RunPaths::readsFolder(const std::string& folder)
{
    folders_.push_back(inputAt(folder));
}

void RunPaths::writes(const std::string& file)
{
    outputs_.push_back(outputAt(file));
}

void RunPaths::writesFrames(const FrameNames& names)
{
    outputs_.push_back(outputAt(names.folder));
    outputs_.back().frames = names;
}

void RunPaths::refuseInput(const Place& output, const Place& input) const
{
    if (isSame(output, input) || isFrameOf(output, input))
        throw InputError(fmt::format("{} would be written over {}, which is read; give the output another name",
                                     output.given, input.given));
}

/// Refuses frames that are links to inputs or outputs.
void RunPaths::checkLinks(const Place& folder) const
{
    std::error_code error;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path, error)) {
        if (!entry.is_symlink(error) || !folder.frames->has(entry.path().filename().string())) continue;
        const Place frame = outputAt(entry.path().string());
        for (const Place& input : inputs_) refuseInput(frame, input);
        for (const Place& output : outputs_)
            if (&output != &folder && isSame(frame, output))
                throw InputError(
                    fmt::format("{} would be written twice; remove the link {}", output.path, frame.given));
    }
}

void RunPaths::check() const
{
    for (size_t i = 0; i < outputs_.size(); ++i) {
        const Place& output = outputs_[i];
        for (const Place& input : inputs_) refuseInput(output, input);
        for (const Place& folder : folders_)
            if (output.exists && output.path.starts_with(folder.path + "/") && !output.frames)
                throw InputError(fmt::format("{} is in {}, which is read; give the output another place", output.given,
                                             folder.given));
        for (size_t k = 0; k < i; ++k) {
            const Place& other = outputs_[k];
            if (output.keeps && other.keeps && output.device == other.device && output.inode == other.inode)
                throw InputError(fmt::format("{} would have two outputs mixed; give one of them a file", output.given));
            if (output.isStream && other.isStream) continue;
            for (const auto& [file, inside] : {std::pair{&output, &other}, std::pair{&other, &output}})
                if (!file->isStream && !file->frames && inside->path.starts_with(file->path + "/"))
                    throw InputError(fmt::format("{} is to be a file, and {} to lie in it; give one another name",
                                                 file->given, inside->given));
            if (output.frames && other.frames && !output.frames->mayMeet(*other.frames)) continue;
            if (isSame(output, other) || isFrameOf(output, other) || isFrameOf(other, output))
                throw InputError(fmt::format("{} would be written twice; give each output a name of its own",
                                             !output.frames ? output.path : other.path));
        }
        if (output.frames) checkLinks(output);
    }
}

}  // namespace knuckle
