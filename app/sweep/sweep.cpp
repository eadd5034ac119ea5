#include "app/sweep/sweep.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"
#include "sim/base/files/output_file.h"

namespace knuckle {

namespace fs = std::filesystem;

Sweep Sweep::read(const SweepOptions& options)
{
    Sweep sweep{readPlan(options.plan), {}, options.folder};
    sweep.runs = runsOf(sweep.plan);
    if (sweep.folder.empty()) sweep.folder = "out/" + sweep.plan.name;
    while (sweep.folder.size() > 1 && sweep.folder.ends_with('/')) sweep.folder.pop_back();
    return sweep;
}

void Sweep::requireRuns() const
{
    std::error_code ignored;
    if (!fs::exists(headPath(), ignored))
        throw InputError(fmt::format("folder {} has no runs of {} yet; `knuckle sweep {}` runs them, -o names another",
                                     folder, plan.path, plan.path));
    const JsonFile head = readJsonFile(headPath());
    if (!head.root.is_object() || head.root.value("fingerprint", Json()) != Json(sweepFingerprint(plan)))
        throw InputError(fmt::format("folder {} has runs of another plan, or {} or its scene has changed since; "
                                     "give another one with -o, or remove it",
                                     folder, plan.path));
}

void Sweep::open() const
{
    requireWritableFolder(folder);
    std::error_code ignored;
    requireRoom(folder);
    if (!fs::exists(headPath(), ignored)) {
        const Json head = {{"plan", plan.path}, {"fingerprint", sweepFingerprint(plan)}, {"runs", runs.size()}};
        OutputFile file(headPath());
        file.write(head.dump(2) + "\n");
        file.commitDurably();
    }
    requireRuns();
}

void requireRoom(const std::string& folder)
{
    constexpr size_t BYTES = size_t{1} << 16;
    std::error_code ignored;
    const std::string path = fs::absolute(fmt::format("{}/.knuckle_room_{}", folder, getpid()), ignored).string();
    const Leftover leftover(path);
    const FileDescriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600));
    int error = file.get() < 0 ? errno : writeAll(file.get(), std::string(BYTES, '\0'));
    // Shared storage says it only here.
    if (error == 0 && fsync(file.get()) != 0 && errno != EINVAL) error = errno;
    unlink(path.c_str());
    if (error != 0)
        throw RunError(fmt::format("folder {} cannot be written to: {}; make room, then the same command goes on",
                                   folder, std::strerror(error)));
}

}  // namespace knuckle
