#include "sim/base/files/output_place.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <thread>

#include "sim/base/errors.h"

namespace knuckle {

namespace {

namespace fs = std::filesystem;

constexpr int MOST_LINKS = 40;
constexpr size_t SHOWN = 160;  // characters of a path

[[noreturn]] void fail(const std::string& given, int error)
{
    throw InputError(fmt::format("{} cannot be written: {}; choose another place", given, std::strerror(error)));
}

/// Absolute and without links as far as it exists; the rest is unchanged.
fs::path canonical(const fs::path& path, const std::string& given)
{
    std::error_code error;
    const fs::path absolute = fs::absolute(path, error);
    if (error) throw InputError(fmt::format("{}: the working folder is no longer there; go to another", given));
    fs::path result = fs::weakly_canonical(absolute, error);
    if (error) fail(given, error.value());
    return result;
}

/// The number of one of this process's descriptors: `folder` is /dev/fd, /proc/self/fd, ... without links.
std::optional<int> descriptorIn(const fs::path& folder, const std::string& name)
{
    const std::string own = fmt::format("/proc/{}/", getpid());
    if (!folder.string().starts_with(own) || folder.filename() != "fd") return {};
    const bool digits = !name.empty() && name.size() < 7 && name.find_first_not_of("0123456789") == std::string::npos;
    return digits ? std::optional(std::stoi(name)) : std::nullopt;
}

/// Whether a file is a mount point, as with docker's -v: it cannot be replaced by renaming.
bool isMounted(const std::string& path)
{
    struct statx facts = {};
    return statx(AT_FDCWD, path.c_str(), 0, 0, &facts) == 0 && (facts.stx_attributes & STATX_ATTR_MOUNT_ROOT) != 0;
}

OutputPlace::Kind kindOf(const OutputPlace& place, bool asFolder)
{
    using Kind = OutputPlace::Kind;
    struct stat facts = {};
    if (stat(place.path.c_str(), &facts) != 0) {
        // A parent that is no folder is reported when it has to be made.
        if (errno != ENOENT && errno != ENOTDIR) fail(place.given, errno);
        return asFolder ? Kind::Folder : Kind::File;
    }
    if (S_ISDIR(facts.st_mode)) return Kind::Folder;
    if (S_ISSOCK(facts.st_mode))
        throw InputError(fmt::format("{} is a socket, which nothing can be written to by its name; name a file or a "
                                     "pipe",
                                     place.given));
    return S_ISREG(facts.st_mode) && !isMounted(place.path) ? Kind::File : Kind::Stream;
}

/// Reserves standard output for an output: from now on the program prints to standard error. @returns a copy of it.
int takeStandardOutput()
{
    static int taken = -1;
    if (taken < 0) {
        std::fflush(stdout);
        taken = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
        if (taken >= 0 && dup2(fileno(stderr), STDOUT_FILENO) < 0) {
            const int nothing = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
            dup2(nothing, STDOUT_FILENO);
            close(nothing);
        }
    }
    return taken < 0 ? -1 : fcntl(taken, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
}

/// Without a reader, opening a FIFO would block and ignore signals.
int openWithReader(const std::string& path)
{
    using namespace std::chrono_literals;
    for (;;) {
        const int file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        struct stat facts = {};
        const bool waits = file < 0 && errno == ENXIO && stat(path.c_str(), &facts) == 0 && S_ISFIFO(facts.st_mode);
        if (!waits) {
            if (file >= 0) fcntl(file, F_SETFL, fcntl(file, F_GETFL) & ~O_NONBLOCK);
            return file;
        }
        std::this_thread::sleep_for(10ms);
    }
}

}  // namespace

std::string shownPath(const std::string& path)
{
    if (path.size() <= SHOWN) return path;
    return path.substr(0, SHOWN / 2) + "..." + path.substr(path.size() - SHOWN / 4);
}

std::string folderOf(const std::string& path)
{
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? "." : folder.string();
}

OutputPlace OutputPlace::of(const std::string& path)
{
    if (path.empty()) throw InputError("the name of an output is empty; give it one, or leave its option out");
    OutputPlace place;
    place.given = shownPath(path);
    const auto stream = [&](int descriptor) {
        place.kind = Kind::Stream;
        place.descriptor = descriptor;
        return place;
    };
    if (path == "-") {
        place.given = "standard output";
        return stream(STDOUT_FILENO);
    }
    const bool asFolder = path.ends_with('/');
    fs::path next = path;
    for (int links = 0; links <= MOST_LINKS; ++links) {
        while (!next.has_filename() && next.has_relative_path()) next = next.parent_path();
        const std::string name = next.filename().string();
        if (name.empty() || name == "." || name == "..") {
            place.path = canonical(next, place.given).string();
            place.kind = Kind::Folder;
            return place;
        }
        const fs::path folder = canonical(next.has_parent_path() ? next.parent_path() : ".", place.given);
        if (const auto descriptor = descriptorIn(folder, name)) return stream(*descriptor);
        next = folder / name;
        std::error_code error;
        const fs::path target = fs::read_symlink(next, error);
        if (error) {
            place.path = next.string();
            place.kind = kindOf(place, asFolder);
            return place;
        }
        next = folder / target;
        place.linked = true;
    }
    fail(place.given, ELOOP);
}

int OutputPlace::open() const
{
    const int file = path.empty() && descriptor == STDOUT_FILENO ? takeStandardOutput()
                     : path.empty()                              ? fcntl(descriptor, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)
                                                                 : openWithReader(path);
    if (file < 0) fail(given, errno);
    return file;
}

}  // namespace knuckle
