#include "render/output/ffmpeg.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <utility>

#include "sim/base/errors.h"

extern char** environ;

namespace knuckle {

namespace {

constexpr size_t MAX_MESSAGE = 400;

struct Streams {
    int input = -1, output = -1, log = -1;
};

/// Spawns without a shell; @returns an errno.
int spawn(const std::string& program, std::vector<std::string>& arguments, const Streams& streams, pid_t& child)
{
    std::vector<char*> argv;
    argv.push_back(const_cast<char*>(program.c_str()));
    for (std::string& argument : arguments) argv.push_back(argument.data());
    argv.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, streams.input, STDIN_FILENO);
    if (streams.output >= 0) posix_spawn_file_actions_adddup2(&files, streams.output, STDOUT_FILENO);
    else posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_adddup2(&files, streams.log, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    sigset_t none;
    sigemptyset(&none);
    posix_spawnattr_setsigmask(&attributes, &none);
    // A terminal's Ctrl-C goes to a whole group: ffmpeg ends when this program wants, with what it was given.
    posix_spawnattr_setpgroup(&attributes, 0);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawn(&child, program.c_str(), &files, &attributes, argv.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

}  // namespace

std::string findProgram(const std::string& name)
{
    const char* path = std::getenv("PATH");
    std::istringstream folders(path != nullptr ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        std::string candidate = (folder.empty() ? "." : folder) + "/" + name;
        std::error_code error;
        if (std::filesystem::is_regular_file(candidate, error) && access(candidate.c_str(), X_OK) == 0)
            return candidate;
    }
    return {};
}

Ffmpeg::Ffmpeg(const std::string& program, std::vector<std::string> arguments, int output, std::string purpose)
    : purpose_(std::move(purpose))
{
    int ends[2] = {-1, -1};
    log_ = memfd_create("ffmpeg messages", MFD_CLOEXEC);
    int error = log_ < 0 || pipe2(ends, O_CLOEXEC) != 0 ? errno : 0;
    if (error == 0) {
        input_ = ends[1];
        error = spawn(program, arguments, {ends[0], output, log_}, child_);
        close(ends[0]);
    }
    if (error == 0) {
        leftover_.emplace(child_);
        return;
    }
    closeInput();
    if (log_ >= 0) close(log_);
    throw RunError(fmt::format("{}: {} cannot be started: {}", purpose_, program, std::strerror(error)));
}

Ffmpeg::~Ffmpeg()
{
    closeInput();
    if (child_ > 0) {
        leftover_.reset();
        kill(child_, SIGKILL);
        waitpid(child_, nullptr, 0);
    }
    close(log_);
}

void Ffmpeg::closeInput()
{
    if (input_ >= 0) close(std::exchange(input_, -1));
}

void Ffmpeg::write(const void* data, size_t byteCount)
{
    const auto* next = static_cast<const char*>(data);
    while (byteCount > 0) {
        const ssize_t written = ::write(input_, next, byteCount);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            const int error = errno;
            finish();
            throw RunError(fmt::format("{}: ffmpeg takes no more frames: {}", purpose_, std::strerror(error)));
        }
        next += written;
        byteCount -= static_cast<size_t>(written);
    }
}

void Ffmpeg::finish()
{
    closeInput();
    if (child_ <= 0) return;
    int status = 0;
    siginfo_t ended = {};
    while (waitid(P_PID, static_cast<id_t>(child_), &ended, WEXITED | WNOWAIT) < 0 && errno == EINTR) {
    }
    leftover_.reset();  // before another process may get its number
    while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
    }
    child_ = -1;
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return;
    const std::string how = WIFSIGNALED(status) ? fmt::format("was ended by signal {}", WTERMSIG(status))
                                                : fmt::format("failed with exit code {}", WEXITSTATUS(status));
    throw RunError(fmt::format("{}: ffmpeg {}: {}", purpose_, how, messages()));
}

std::string Ffmpeg::messages() const
{
    std::string text(MAX_MESSAGE, '\0');
    const ssize_t count = pread(log_, text.data(), text.size(), 0);
    text.resize(count > 0 ? static_cast<size_t>(count) : 0);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back()))) text.pop_back();
    for (size_t at; (at = text.find('\n')) != std::string::npos;) text.replace(at, 1, "; ");
    return text.empty() ? "it said nothing" : text;
}

}  // namespace knuckle
