#include "app/run/shell_command.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
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
/// A word of these needs no quotes.
constexpr const char* PLAIN_LETTERS = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_@%+=:,./-";

/// Starts it with its output and messages in `output`; @returns an errno.
int spawnShell(std::string line, const std::string& folder, const std::vector<std::string>& environment, int output,
               pid_t& child)
{
    std::string shell = "/bin/sh", option = "-c";
    std::array<char*, 4> argv{shell.data(), option.data(), line.data(), nullptr};
    std::vector<std::string> own = environment;
    std::vector<char*> variables;
    for (std::string& variable : own) variables.push_back(variable.data());
    const auto isReplaced = [&](std::string_view inherited) {
        const std::string_view name = inherited.substr(0, inherited.find('=') + 1);
        return std::ranges::any_of(environment, [&](const std::string& other) { return other.starts_with(name); });
    };
    for (char** variable = environ; *variable != nullptr; ++variable)
        if (!isReplaced(*variable)) variables.push_back(*variable);
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

/// What a file in memory holds.
std::string contentOf(int file)
{
    std::string text(static_cast<size_t>(std::max<off_t>(0, lseek(file, 0, SEEK_END))), '\0');
    const ssize_t count = pread(file, text.data(), text.size(), 0);
    text.resize(static_cast<size_t>(std::max<ssize_t>(0, count)));
    return text;
}

}  // namespace

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

std::string quotedForShell(const std::string& word)
{
    if (!word.empty() && word.find_first_not_of(PLAIN_LETTERS) == std::string::npos) return word;
    std::string text = "'";
    for (const char letter : word) text += letter == '\'' ? "'\\''" : std::string(1, letter);
    return text + "'";
}

ShellResult runShell(const std::string& line, const std::string& folder, const std::vector<std::string>& environment)
{
    // Not a pipe, whose end comes only when everything that the command left running has ended.
    const FileDescriptor output(memfd_create("output of a command", MFD_CLOEXEC));
    if (output.get() < 0) throw RunError(fmt::format("no room for a command's output: {}", std::strerror(errno)));
    pid_t child = -1;
    if (const int error = spawnShell(line, folder, environment, output.get(), child); error != 0)
        throw InputError(fmt::format("{} cannot be started in folder {}: {}", line, folder, std::strerror(error)));
    const Leftover leftover(child);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) continue;
    ShellResult result{.failure = failureOf(status), .output = contentOf(output.get())};
    result.lastLine = lastLineOf(result.output);
    return result;
}

}  // namespace knuckle
