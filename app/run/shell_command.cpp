#include "app/run/shell_command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>

#include "sim/base/errors.h"
#include "sim/base/files/file_descriptor.h"
#include "sim/base/files/leftovers.h"

extern char** environ;

namespace knuckle {

namespace {

constexpr size_t MAX_LINE = 300;

/// Starts it with its output and messages in `output`; @returns an errno.
int spawnShell(std::string line, const std::string& folder, const std::vector<std::string>& environment, int output,
               pid_t& child)
{
    std::string shell = "/bin/sh", option = "-c";
    std::array<char*, 4> argv{shell.data(), option.data(), line.data(), nullptr};
    std::vector<std::string> own = environment;
    std::vector<char*> variables;
    for (std::string& variable : own) variables.push_back(variable.data());
    for (char** variable = environ; *variable != nullptr; ++variable) variables.push_back(*variable);
    variables.push_back(nullptr);

    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&files, output, STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, output, STDERR_FILENO);
    posix_spawn_file_actions_addchdir_np(&files, folder.empty() ? "." : folder.c_str());
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    // This program ignores SIGPIPE, and programs expect to end by it.
    sigset_t defaults;
    sigemptyset(&defaults);
    sigaddset(&defaults, SIGPIPE);
    posix_spawnattr_setsigdefault(&attributes, &defaults);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    const int error = posix_spawn(&child, shell.c_str(), &files, &attributes, argv.data(), variables.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
}

std::string readAll(int descriptor)
{
    std::string text;
    std::array<char, 65536> buffer{};
    for (;;) {
        const ssize_t count = read(descriptor, buffer.data(), buffer.size());
        if (count == 0 || (count < 0 && errno != EINTR)) return text;
        if (count > 0) text.append(buffer.data(), static_cast<size_t>(count));
    }
}

std::string lastLineOf(const std::string& text)
{
    const size_t end = text.find_last_not_of(" \t\r\n");
    if (end == std::string::npos) return {};
    const size_t before = text.rfind('\n', end);
    const size_t start = before == std::string::npos ? 0 : before + 1;
    return text.substr(start, std::min(end + 1 - start, MAX_LINE));
}

std::string failureOf(int status)
{
    if (WIFSIGNALED(status)) return fmt::format("was ended by signal {}", WTERMSIG(status));
    if (WEXITSTATUS(status) == 0) return {};
    return fmt::format("failed with exit code {}", WEXITSTATUS(status));
}

}  // namespace

ShellResult runShell(const std::string& line, const std::string& folder, const std::vector<std::string>& environment)
{
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) throw RunError(fmt::format("no pipe: {}", std::strerror(errno)));
    const FileDescriptor output(ends[0]);
    pid_t child = -1;
    {
        const FileDescriptor input(ends[1]);
        if (const int error = spawnShell(line, folder, environment, input.get(), child); error != 0)
            throw InputError(fmt::format("{} cannot be started in folder {}: {}", line, folder, std::strerror(error)));
    }
    const Leftover leftover(child);
    ShellResult result{.output = readAll(output.get())};
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    result.failure = failureOf(status);
    result.lastLine = lastLineOf(result.output);
    return result;
}

}  // namespace knuckle
